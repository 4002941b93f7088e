#include "plugins/planner/footprint.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "stope/random.hpp"

namespace stope::planner {
namespace {

const Vehicle kTruck;

OccupancyGrid speckled(double resolution, double yaw, double share, std::uint64_t seed) {
  OccupancyGrid grid;
  grid.frame = {static_cast<std::int32_t>(60 / resolution),
                static_cast<std::int32_t>(60 / resolution),
                resolution,
                {100, -50, yaw}};
  grid.cells.assign(grid.frame.size(), OccupancyGrid::kFree);
  Random random(seed);
  for (auto& cell : grid.cells) {
    if (random.uniform() < share)
      cell = random.below(2) == 0 ? OccupancyGrid::kOccupied : OccupancyGrid::kUnknown;
  }
  return grid;
}

Pose2 somewhere(const OccupancyGrid& grid, Random& random, double border) {
  const double side = 60 - 2 * border;
  const Vector2 at = grid.frame.to_map((border + side * random.uniform()) / grid.frame.resolution,
                                       (border + side * random.uniform()) / grid.frame.resolution);
  return {at.x(), at.y(), random.uniform(-7, 7)};
}

/// Whether a place of the outline, looked at every few centimetres, lies in an obstacle.
bool sampled_touch(const OccupancyGrid& grid, const Pose2& pose, double wider) {
  const double left = -kTruck.rear_overhang - wider, right = kTruck.nose() + wider;
  const double side = kTruck.width / 2 + wider;
  for (int i = 0; i <= 300; ++i) {
    for (int j = 0; j <= 120; ++j) {
      const double a = left + (right - left) * i / 300, b = -side + 2 * side * j / 120;
      const auto cell =
          grid.frame.cell_at(pose.x + std::cos(pose.yaw) * a - std::sin(pose.yaw) * b,
                             pose.y + std::sin(pose.yaw) * a + std::cos(pose.yaw) * b);
      if (!cell || grid.cells[grid.frame.place(*cell)] >= 127) return true;
    }
  }
  return false;
}

TEST(Footprint, TouchesWhatSamplesOfItTouch) {
  Random random(5);
  for (const double yaw : {0.0, 0.6}) {
    const OccupancyGrid grid = speckled(0.5, yaw, 0.004, 1);
    const ClearanceField field(grid, {100, -50, 160, 10}, 100);
    const Footprint footprint(kTruck, grid, field);
    int touched = 0;
    for (int i = 0; i < 300; ++i) {
      const Pose2 pose = somewhere(grid, random, 2);
      const double wider = random.uniform(0, 0.6);
      touched += footprint.free(pose, wider) ? 0 : 1;
      // Samples miss what only a corner of a cell reaches into, by less than 4 cm.
      if (sampled_touch(grid, pose, wider)) {
        EXPECT_FALSE(footprint.free(pose, wider));
      }
      if (!sampled_touch(grid, pose, wider + 0.04)) {
        EXPECT_TRUE(footprint.free(pose, wider));
      }
    }
    EXPECT_GT(touched, 30);
    EXPECT_LT(touched, 270);
  }
}

TEST(Footprint, ClearancesAreNeverTooLong) {
  Random random(6);
  for (const double resolution : {0.1, 0.5, 1.0}) {
    const OccupancyGrid grid = speckled(resolution, 0.3, 0.001 * resolution, 2);
    const ClearanceField field(grid, {100, -50, 160, 10}, 100);
    const Footprint footprint(kTruck, grid, field);
    for (int i = 0; i < 100; ++i) {
      const Pose2 pose = somewhere(grid, random, 12);
      const double quick = footprint.quick_clearance(pose), clearance = footprint.clearance(pose);
      if (quick > 0) {
        EXPECT_TRUE(footprint.free(pose, quick / std::sqrt(2.0)));
      }
      EXPECT_LE(quick, clearance + resolution);
      if (clearance > 0.01) {
        EXPECT_TRUE(footprint.free(pose, clearance / std::sqrt(2.0) - 0.001));
      }
      if (clearance < 4) {
        EXPECT_FALSE(footprint.free(pose, clearance + 1.5 * resolution));
      }
    }
  }
}

TEST(Footprint, ASweepFindsAnObstacleBetweenTwoPoses) {
  OccupancyGrid grid = speckled(0.5, 0, 0, 3);
  const Cell post{60, 30};  // at (130.25, -34.75)
  grid.cells[grid.frame.place(post)] = OccupancyGrid::kOccupied;
  const ClearanceField field(grid, {100, -50, 160, 10}, 100);
  const Footprint footprint(kTruck, grid, field);
  const auto sweep = [&](double y) { return footprint.first_touch({{110, y, 0}, {{40, 0, 0}}}); };
  // Half a width, the margin, and half of what moves between two looks.
  const double reach = 2 + 0.5 + Footprint::kBetween / 2;
  EXPECT_FALSE(sweep(-35 - reach - 0.01));
  const auto touch = sweep(-35 - reach + 0.02);
  ASSERT_TRUE(touch);
  EXPECT_NEAR(touch->along, 130 - 6.5 - 0.5 - 110, 0.3);
  EXPECT_EQ(touch->obstacle, grid.frame.centre(post));
  // Turning on the spot is not possible, but swinging the nose round is: the corner is seen too.
  const DriveCurve swing{{120, -40, 0}, {{18.85, 1.0 / 12, 1.0 / 12}}};
  EXPECT_TRUE(footprint.first_touch(swing));
}

TEST(Footprint, OffTheMapIsAnObstacle) {
  const OccupancyGrid grid = speckled(0.5, 0, 0, 4);
  const ClearanceField field(grid, {100, -50, 160, 10}, 100);
  const Footprint footprint(kTruck, grid, field);
  EXPECT_TRUE(footprint.free({104, -40, 0}, 0));
  EXPECT_FALSE(footprint.free({102, -40, 0}, 0));
  EXPECT_FALSE(footprint.free({1e12, 0, 0}, 0));
  EXPECT_FALSE(footprint.free({std::nan(""), 0, 0}, 0));
}

}  // namespace
}  // namespace stope::planner
