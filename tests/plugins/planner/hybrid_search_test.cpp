#include "plugins/planner/hybrid_search.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "tests/plugins/planner/drawn_ground.hpp"

namespace stope::planner {
namespace {

/// 210 x 130 m with a wall across it that leaves a gap from y = 60 on.
OccupancyGrid walled_ground(double gap) {
  OccupancyGrid grid = free_ground(420, 260);
  fill(grid, 100, 0, 102, 60, OccupancyGrid::kOccupied);
  fill(grid, 100, 60 + gap, 102, 130, OccupancyGrid::kOccupied);
  return grid;
}

/// A search from one side of the wall to the other.
struct WallSearch {
  explicit WallSearch(double gap) : grid(walled_ground(gap)) {}
  HybridResult search(const HybridRules& rules) const {
    return hybrid_search(start, {goal}, ground, field, rules, checkpoint);
  }

  OccupancyGrid grid;
  Pose2 start{70, 40, 0}, goal{130, 40, 0};
  ClearanceField field{grid, MapBox{70, 40, 130, 40}, 45};
  Vehicle vehicle;
  Drivability ground{vehicle, grid, field, nullptr};
  std::function<void()> checkpoint = [] {};
};

TEST(HybridSearch, ArrivesExactlyOnTheOtherSideOfAWall) {
  const WallSearch walled(14);
  const auto found = walled.search({});
  ASSERT_TRUE(found.curve);
  const Pose2 end = found.curve->end();
  EXPECT_NEAR(end.x, walled.goal.x, 1e-6);
  EXPECT_NEAR(end.y, walled.goal.y, 1e-6);
  EXPECT_NEAR(std::remainder(end.yaw - walled.goal.yaw, 2 * std::numbers::pi), 0, 1e-6);
  EXPECT_TRUE(walled.ground.drivable(*found.curve));
  for (const CurvePiece& piece : found.curve->pieces) EXPECT_GT(piece.length, 0);
}

TEST(HybridSearch, GivesUpAfterAsManyPosesAsItMayLookAt) {
  // The gap lets a point through that keeps half the truck's width, but not the truck with its
  // margin: nothing but the limit ends the search before all of the ground is looked at.
  const WallSearch narrow(4.5);
  for (const std::size_t most : {std::size_t{1}, std::size_t{50}, std::size_t{400}}) {
    const auto found = narrow.search({false, 12, most});
    EXPECT_FALSE(found.curve);
    EXPECT_EQ(found.poses, most);
  }
  // A way that takes more than a few poses is found with as many as it takes, not with fewer.
  const WallSearch wide(14);
  const std::size_t needed = wide.search({}).poses;
  ASSERT_GT(needed, 10U);
  EXPECT_TRUE(wide.search({false, 12, needed + 1}).curve);
  EXPECT_FALSE(wide.search({false, 12, needed - 1}).curve);
}

TEST(HybridSearch, LooksUpAtEachPose) {
  WallSearch narrow(4.5);
  std::size_t looked = 0;
  narrow.checkpoint = [&] { ++looked; };
  const std::size_t poses = narrow.search({false, 12, 100}).poses;
  EXPECT_GE(looked, poses);
  struct Stopped {};
  narrow.checkpoint = [&] { throw Stopped(); };
  EXPECT_THROW(narrow.search({false, 12, 100}), Stopped);
}

}  // namespace
}  // namespace stope::planner
