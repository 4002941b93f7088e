#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "plugins/prior/dilate_track.hpp"
#include "tests/plugins/stage_harness.hpp"

extern "C" const stope::StageEntry* stope_stage_TrajectoryDilation();

namespace stope::prior {
namespace {

using stope::testing::StageHarness;

double distance_to(const std::vector<Vector2>& line, const Vector2& point) {
  double best = (point - line.front()).norm();
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Vector2 span = line[i] - line[i - 1];
    const double square = span.squaredNorm();
    const double t =
        square > 0 ? std::clamp((point - line[i - 1]).dot(span) / square, 0.0, 1.0) : 0;
    best = std::min(best, (point - line[i - 1] - t * span).norm());
  }
  return best;
}

Trajectory through(const std::vector<Vector2>& line) {
  Trajectory trajectory;
  for (const Vector2& point : line) {
    StampedPose pose;
    pose.stamp = static_cast<Stamp>(trajectory.poses.size());
    pose.T_map_lidar.translation = Vector3(point.x(), point.y(), 1);
    trajectory.poses.push_back(pose);
  }
  return trajectory;
}

TEST(DilateTrack, IsTheDilationByADiscOnGridsOfAnyYaw) {
  Random random(2);
  for (int trial = 0; trial < 60; ++trial) {
    OccupancyGrid grid;
    grid.frame = {
        90,
        70,
        0.3,
        {random.uniform(-5, 5), random.uniform(-5, 5), trial % 2 == 0 ? 0 : random.uniform(-3, 3)}};
    grid.cells.assign(grid.frame.size(), OccupancyGrid::kUnknown);
    std::vector<Vector2> line;
    const auto points = 1 + random.below(6);
    for (std::uint64_t i = 0; i < points; ++i)
      line.push_back(grid.frame.to_map(random.uniform(-10, 100), random.uniform(-10, 80)));
    if (trial % 5 == 0) line.push_back(line.back());                      // standing still
    if (trial % 7 == 0) line.push_back(line.back() + Vector2(0.0, 4.0));  // along an axis
    const double radius = random.uniform(0.1, 4);
    dilate_track(grid, line, radius, OccupancyGrid::kFree);
    for (std::int32_t row = 0; row < grid.frame.height; ++row) {
      for (std::int32_t column = 0; column < grid.frame.width; ++column) {
        const double distance = distance_to(line, grid.frame.centre({column, row}));
        if (std::abs(distance - radius) < 1e-9) continue;
        ASSERT_EQ(grid.cells[grid.frame.place({column, row})],
                  distance < radius ? OccupancyGrid::kFree : OccupancyGrid::kUnknown)
            << "trial " << trial << " at " << column << ", " << row;
      }
    }
  }
}

TEST(TrajectoryDilation, AStraightRoadHasItsWidth) {
  const auto grid = StageHarness(stope_stage_TrajectoryDilation())
                        .input("trajectory", through({{10.1, 20.2}, {60.1, 20.2}}))
                        .set("width", 8.0)
                        .set("resolution", 0.5)
                        .apply<OccupancyGrid>();
  const double area = 0.25 * static_cast<double>(std::count(grid.cells.begin(), grid.cells.end(),
                                                            OccupancyGrid::kFree));
  EXPECT_NEAR(area, 50 * 8 + 3.14159265 * 16, 6);
  EXPECT_EQ(std::count(grid.cells.begin(), grid.cells.end(), OccupancyGrid::kOccupied), 0);
  // On the lattice of multiples of the resolution, with the margin round the road.
  EXPECT_EQ(std::remainder(grid.frame.origin.x, 0.5), 0);
  EXPECT_LE(grid.frame.origin.x, 10.1 - 4 - 5);
  EXPECT_GT(grid.frame.origin.x, 10.1 - 4 - 5 - 0.5);
}

TEST(TrajectoryDilation, OutsideMayBeOccupied) {
  const auto grid = StageHarness(stope_stage_TrajectoryDilation())
                        .input("trajectory", through({{0, 0}}))
                        .set("outside", std::string("occupied"))
                        .apply<OccupancyGrid>();
  EXPECT_EQ(std::count(grid.cells.begin(), grid.cells.end(), OccupancyGrid::kUnknown), 0);
  EXPECT_EQ(grid.cells.front(), OccupancyGrid::kOccupied);
}

TEST(TrajectoryDilation, RefusesWhatIsNoRoute) {
  const auto sentence = [](Trajectory trajectory) {
    return stope::testing::error_of([&] {
      StageHarness(stope_stage_TrajectoryDilation())
          .input("trajectory", std::move(trajectory))
          .apply<OccupancyGrid>();
    });
  };
  EXPECT_NE(sentence({}).find("no pose with a place"), std::string::npos);
  EXPECT_NE(sentence(through({{0, 0}, {1e12, 1e12}})).find("are its poses right?"),
            std::string::npos);
}

}  // namespace
}  // namespace stope::prior
