#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "plugins/metric/drive_validity.hpp"
#include "tests/plugins/planner/drawn_ground.hpp"
#include "tests/plugins/stage_harness.hpp"

extern "C" const stope::StageEntry* stope_stage_ReedsShepp();
extern "C" const stope::StageEntry* stope_stage_Smooth();

namespace stope::planner {
namespace {

using stope::testing::error_of;
using stope::testing::StageHarness;
using Numbers = std::vector<double>;

constexpr double kPi = std::numbers::pi;

// A yard of 60 m, from whose middle a road leads to the right.
OccupancyGrid yard_and_road() {
  return roads_of(16, {{{50, 60}, {190, 60}}, {{30, 45}, {70, 45}}, {{30, 75}, {70, 75}}});
}

Path driven(const OccupancyGrid& grid) {
  return StageHarness(stope_stage_Smooth())
      .input("path", path_of({{60, 60}, {170, 60}}))
      .input("grid", grid)
      .apply<Path>();
}

StageHarness miles(const OccupancyGrid& grid) {
  StageHarness stage(stope_stage_ReedsShepp());
  stage.input("drive", driven(grid)).input("grid", grid);
  return stage;
}

void expect_drivable(const Path& path, const OccupancyGrid& grid) {
  metric::TruckLimits truck;
  truck.margin = 0.5;
  const auto found = metric::check_drive(path, grid, nullptr, truck);
  EXPECT_EQ(found.violations(), 0U) << found.first;
}

TEST(ReedsShepp, WithoutStartAndGoalThePathStays) {
  const OccupancyGrid grid = yard_and_road();
  const Path before = driven(grid), after = miles(grid).apply<Path>();
  ASSERT_EQ(after.points.size(), before.points.size());
  for (std::size_t i = 0; i < after.points.size(); ++i)
    EXPECT_EQ(after.points[i].x, before.points[i].x);
}

TEST(ReedsShepp, TurnsRoundOntoThePathAndArrivesAsTold) {
  const OccupancyGrid grid = yard_and_road();
  auto stage = miles(grid);
  const Path path = stage.set("start", Numbers{60, 60})
                        .set("start_heading", kPi / 2)
                        .set("goal", Numbers{175, 60})
                        .set("goal_heading", 0.0)
                        .apply<Path>();
  expect_drivable(path, grid);
  EXPECT_NEAR(path.points.front().yaw, kPi / 2, 1e-9);
  EXPECT_NEAR(path.points.back().x, 175, 1e-4);
  EXPECT_NEAR(std::remainder(path.points.back().yaw, 2 * kPi), 0, 1e-4);
  EXPECT_EQ(path.points.front().speed, 0);
  EXPECT_EQ(path.points.back().speed, 0);
  EXPECT_EQ(stage.context().sentences.at(0).find("the first mile has "), 0U);
}

TEST(ReedsShepp, TakesTheStartFromAPoseAndStopsInAnArea) {
  const OccupancyGrid grid = yard_and_road();
  StampedPose pose;
  pose.T_map_lidar.translation = {58, 63, 0};
  const Path path = miles(grid)
                        .input("pose", pose)
                        .set("goal_area", Numbers{172, 55, 182, 55, 182, 65, 172, 65})
                        .apply<Path>();
  expect_drivable(path, grid);
  EXPECT_NEAR(path.points.front().x, 58, 1e-9);
  EXPECT_NEAR(path.points.front().y, 63, 1e-9);
  EXPECT_GT(path.points.back().x, 172);
  EXPECT_LT(path.points.back().x, 182);
}

TEST(ReedsShepp, APathThatEndsInTheAreaStays) {
  const OccupancyGrid grid = yard_and_road();
  const Path before = driven(grid);
  auto stage = miles(grid);
  const Path after =
      stage.set("goal_area", Numbers{160, 55, 182, 55, 182, 65, 160, 65}).apply<Path>();
  ASSERT_EQ(after.points.size(), before.points.size());
  EXPECT_EQ(after.points.back().x, before.points.back().x);
  EXPECT_EQ(stage.context().sentences.at(0).find("the path already ends in the goal_area"), 0U);
  // Not if it is to stand otherwise there.
  const Path turned = miles(grid)
                          .set("goal_area", Numbers{160, 55, 182, 55, 182, 65, 160, 65})
                          .set("goal_heading", 0.2)
                          .apply<Path>();
  EXPECT_NEAR(turned.points.back().yaw, 0.2, 1e-4);
}

TEST(ReedsShepp, RefusesWithASentence) {
  const OccupancyGrid grid = yard_and_road();
  const auto sentence = [&](StageHarness stage) { return error_of([&] { stage.apply<Path>(); }); };
  auto blocked = miles(grid);
  blocked.set("start", Numbers{20, 100}).set("start_heading", 0.0);
  EXPECT_NE(sentence(std::move(blocked)).find("the truck cannot even stand there"),
            std::string::npos);
  auto halfway = miles(grid);
  halfway.set("start", Numbers{60, 60});
  EXPECT_NE(sentence(std::move(halfway)).find("without start_heading"), std::string::npos);
  auto corner = miles(grid);
  corner.input("drive", path_of({{60, 60}, {100, 60}, {100, 65}}));
  EXPECT_NE(sentence(std::move(corner)).find("put planner/smooth before this stage"),
            std::string::npos);
  auto area = miles(grid);
  area.set("goal_area", Numbers{0, 0, 10, 10, 20, 20});
  EXPECT_NE(sentence(std::move(area)).find("holds no place"), std::string::npos);
  auto none = miles(grid);
  none.input("drive", Path{});
  EXPECT_NE(sentence(std::move(none)).find("the path has no points"), std::string::npos);
}

}  // namespace
}  // namespace stope::planner
