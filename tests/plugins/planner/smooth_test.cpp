#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "plugins/metric/drive_validity.hpp"
#include "stope/digest.hpp"
#include "tests/plugins/planner/drawn_ground.hpp"
#include "tests/plugins/stage_harness.hpp"

extern "C" const stope::StageEntry* stope_stage_Smooth();

namespace stope::planner {
namespace {

using stope::testing::error_of;
using stope::testing::StageHarness;

constexpr double kPi = std::numbers::pi;

StageHarness smooth(const Path& path, const OccupancyGrid& grid) {
  StageHarness stage(stope_stage_Smooth());
  stage.input("path", path).input("grid", grid);
  return stage;
}

metric::DriveValidity judge(const Path& path, const OccupancyGrid& grid, double margin = 0.5,
                            const ElevationGrid* elevation = nullptr) {
  metric::TruckLimits truck;
  truck.margin = margin;
  return metric::check_drive(path, grid, elevation, truck);
}

void expect_drivable(const Path& path, const OccupancyGrid& grid,
                     const ElevationGrid* elevation = nullptr) {
  const auto found = judge(path, grid, 0.5, elevation);
  EXPECT_EQ(found.violations(), 0U) << found.first;
  EXPECT_NEAR(found.length, path.length, 1e-3 * path.length);
}

void expect_sentence(const std::string& sentence, const std::string& part) {
  EXPECT_NE(sentence.find(part), std::string::npos) << "got: " << sentence;
}

TEST(Smooth, RoundsACornerWithinTheRoad) {
  const OccupancyGrid grid = roads_of(16, {{{20, 20}, {100, 20}, {100, 100}}});
  const Path path = smooth(path_of({{20, 20}, {100, 20}, {100, 100}}), grid).apply<Path>();
  expect_drivable(path, grid);
  EXPECT_NEAR(path.points.front().x, 20, 1e-6);
  EXPECT_NEAR(path.points.back().x, 100, 0.3);
  EXPECT_NEAR(path.points.back().y, 100, 0.3);
  EXPECT_LT(path.length, 160);
  EXPECT_GT(path.length, 140);
  // Curvature is continuous: no stop on the way, and it never changes faster than wheels turn.
  for (std::size_t i = 1; i + 1 < path.points.size(); ++i) {
    EXPECT_GT(path.points[i].speed, 0);
    const double way = std::hypot(path.points[i].x - path.points[i - 1].x,
                                  path.points[i].y - path.points[i - 1].y);
    EXPECT_LE(std::abs(path.points[i].curvature - path.points[i - 1].curvature),
              way * 1.001 / (12 * 6) + 1e-9);
  }
}

TEST(Smooth, StandsAsToldAtBothEnds) {
  const OccupancyGrid grid = roads_of(50, {{{40, 50}, {160, 50}}});
  const Path path = smooth(path_of({{40, 50}, {160, 50}}), grid)
                        .set("start_heading", kPi / 2)
                        .set("goal_heading", -kPi / 2)
                        .apply<Path>();
  expect_drivable(path, grid);
  EXPECT_NEAR(path.points.front().yaw, kPi / 2, 1e-9);
  EXPECT_NEAR(path.points.back().yaw, -kPi / 2, 0.021);
}

TEST(Smooth, SpeedsKeepToTheirLimits) {
  const OccupancyGrid grid = roads_of(16, {{{20, 20}, {200, 20}, {200, 100}}});
  const Path path = smooth(path_of({{20, 20}, {200, 20}, {200, 100}}), grid)
                        .set("lateral_acceleration", 0.8)
                        .set("max_speed", 9.0)
                        .apply<Path>();
  EXPECT_LE(judge(path, grid).lateral_acceleration, 0.8 + 1e-9);
  EXPECT_EQ(path.points.front().speed, 0);
  EXPECT_EQ(path.points.back().speed, 0);
  double top = 0;
  for (std::size_t i = 1; i < path.points.size(); ++i) {
    const auto &a = path.points[i - 1], &b = path.points[i];
    const double way = std::hypot(b.x - a.x, b.y - a.y),
                 gain = b.speed * b.speed - a.speed * a.speed;
    EXPECT_LE(gain, 2 * 0.5 * way + 0.01);
    EXPECT_GE(gain, -2 * 0.7 * way - 0.01);
    top = std::max(top, b.speed);
  }
  EXPECT_NEAR(top, 9, 1e-9);
}

TEST(Smooth, RefusesATurnThatIsTooTightAndSaysHowTight) {
  // With its margin and a radius of 12 m the truck's inner side runs on a circle of 9.5 m, the
  // outer front corner on one of 16.1 m: a lane with a right angle must be 16.1 - 9.5 / sqrt(2)
  // = 9.4 m wide. With 6 m, 8.5 m are enough.
  const OccupancyGrid grid = roads_of(9, {{{20, 20}, {100, 20}, {100, 100}}}, false);
  const auto sentence = error_of([&] {
    smooth(path_of({{20, 20}, {100, 20}, {100, 90}}), grid).apply<Path>();
  });
  expect_sentence(sentence, "m along the route, the turn needs a radius of ");
  expect_sentence(sentence, "m but the truck needs 12.0 m");
  // Another truck can.
  const Path path = smooth(path_of({{20, 20}, {100, 20}, {100, 90}}), grid)
                        .set("turning_radius", 5.0)
                        .set("length", 5.0)
                        .set("wheelbase", 3.0)
                        .set("rear_overhang", 1.0)
                        .set("width", 2.5)
                        .apply<Path>();
  EXPECT_GT(path.length, 100);
}

TEST(Smooth, RefusesAGapTheTruckDoesNotFitThrough) {
  OccupancyGrid grid = roads_of(16, {{{20, 20}, {150, 20}}});
  fill(grid, 80, 0, 84, 18, OccupancyGrid::kOccupied);
  fill(grid, 80, 22.5, 84, 40, OccupancyGrid::kUnknown);
  const auto sentence = error_of([&] {
    smooth(path_of({{20, 20}, {140, 20}}), grid).apply<Path>();
  });
  expect_sentence(sentence, "the footprint would touch an obstacle at (");
  expect_sentence(sentence, "m along the route");
}

TEST(Smooth, PassesAGapTheTruckJustFitsThrough) {
  OccupancyGrid grid = roads_of(16, {{{20, 20}, {150, 20}}});
  fill(grid, 80, 0, 84, 19, OccupancyGrid::kOccupied);
  fill(grid, 80, 24.5, 84, 40, OccupancyGrid::kOccupied);
  const Path path = smooth(path_of({{20, 20}, {140, 20}}), grid).apply<Path>();
  expect_drivable(path, grid);
}

TEST(Smooth, ReversesOnlyIfAllowed) {
  // A blind alley too narrow to turn round in one go, and the truck stands with its nose to the
  // wall.
  const OccupancyGrid grid = roads_of(26, {{{20, 50}, {150, 50}}});
  const Path line = path_of({{26, 50}, {140, 50}});
  const auto sentence =
      error_of([&] { smooth(line, grid).set("start_heading", kPi).apply<Path>(); });
  expect_sentence(sentence, "along the route");
  const Path path =
      smooth(line, grid).set("start_heading", kPi).set("allow_reverse", true).apply<Path>();
  expect_drivable(path, grid);
  EXPECT_GE(judge(path, grid).cusps, 1U);
  EXPECT_TRUE(std::any_of(path.points.begin(), path.points.end(),
                          [](const PathPoint& point) { return point.speed < 0; }));
}

TEST(Smooth, TurnsRoundBetweenWallsWhereItMayReverse) {
  // The circle that the truck turns in is 32 m wide, the alley 16 m: it has to go to and fro.
  const OccupancyGrid grid = roads_of(16, {{{20, 50}, {150, 50}}}, false);
  const Path line = path_of({{60, 50}, {140, 50}});
  const auto sentence =
      error_of([&] { smooth(line, grid).set("start_heading", kPi).apply<Path>(); });
  expect_sentence(sentence, "allow reversing (allow_reverse: true), with which a way was found");
  const Path path =
      smooth(line, grid).set("start_heading", kPi).set("allow_reverse", true).apply<Path>();
  expect_drivable(path, grid);
  EXPECT_GE(judge(path, grid).cusps, 2U);
  EXPECT_NEAR(path.points.back().x, 140, 0.3);
}

TEST(Smooth, TurnsRoundAtTheEndOfABlindAlley) {
  // The route leads in, to two metres from where no truck can stand, and out again.
  const OccupancyGrid grid = roads_of(16, {{{20, 50}, {150, 50}}}, false);
  const Path line = path_of({{40, 50}, {140, 50}, {60, 50}});
  const Path path = smooth(line, grid).set("allow_reverse", true).apply<Path>();
  expect_drivable(path, grid);
  EXPECT_NEAR(path.points.back().x, 60, 0.3);
}

TEST(Smooth, TakesTheSharpBendOfAFork) {
  const OccupancyGrid grid = roads_of(16, {{{20, 20}, {150, 50}}, {{20, 80}, {150, 50}}});
  const Path line = path_of({{30, 22.3}, {150, 50}, {30, 77.7}});
  const Path path = smooth(line, grid).set("allow_reverse", true).apply<Path>();
  expect_drivable(path, grid);
  EXPECT_NEAR(path.points.back().x, 30, 0.3);
  EXPECT_NEAR(path.points.back().y, 77.7, 0.3);
}

TEST(Smooth, KeepsToTheGradeOrSaysWhereItIsTooSteep) {
  const OccupancyGrid grid = roads_of(16, {{{20, 20}, {150, 20}}});
  const auto ramp = [&](double grade) {
    ElevationGrid elevation{grid.frame, {}, {}};
    for (std::int32_t row = 0; row < grid.frame.height; ++row) {
      for (std::int32_t column = 0; column < grid.frame.width; ++column) {
        const double x = grid.frame.centre({column, row}).x();
        elevation.cells.push_back(static_cast<float>(grade * std::clamp(x - 80, 0.0, 30.0)));
      }
    }
    return elevation;
  };
  const Path line = path_of({{20, 20}, {140, 20}});
  const ElevationGrid gentle = ramp(0.1), steep = ramp(0.14);
  const Path path = smooth(line, grid).input("elevation", gentle).apply<Path>();
  expect_drivable(path, grid, &gentle);
  EXPECT_NEAR(path.points.back().z, 3, 1e-4);
  const auto sentence =
      error_of([&] { smooth(line, grid).input("elevation", steep).apply<Path>(); });
  expect_sentence(sentence, "m along the route, the slope of 1");
  expect_sentence(sentence, "% is over the truck's max_grade of 12.0 %");
  EXPECT_FALSE(smooth(line, grid)
                   .input("elevation", steep)
                   .set("max_grade", 0.15)
                   .apply<Path>()
                   .points.empty());

  ElevationGrid part = gentle;
  part.frame.width = 100;
  part.cells.resize(part.frame.size());
  expect_sentence(error_of([&] { smooth(line, grid).input("elevation", part).apply<Path>(); }),
                  "the elevation is not known under the truck");
}

TEST(Smooth, RefusesPathsThatAreNone) {
  const OccupancyGrid grid = roads_of(16, {{{20, 20}, {150, 20}}});
  const auto refused = [&](const Path& path) {
    return error_of([&] { smooth(path, grid).apply<Path>(); });
  };
  expect_sentence(refused({}), "the path has no points");
  expect_sentence(refused(path_of({{20, 20}})),
                  "the path has no length: the only one of its points");
  expect_sentence(refused(path_of({{20, 20}, {20, 20}, {20, 20}})), "the path has no length: all");
  expect_sentence(refused(path_of({{20, 20}, {std::nan(""), 20}})), "which is no place");
  expect_sentence(refused(path_of({{20, 20}, {1e300, 20}})), "which is no place");
  expect_sentence(refused(path_of({{20, 20}, {900, 20}})), "the path leaves the map at (");
  expect_sentence(refused(path_of({{20, 60}, {100, 60}})), "the truck cannot stand at the start");
  OccupancyGrid full = grid;
  std::fill(full.cells.begin(), full.cells.end(), OccupancyGrid::kUnknown);
  expect_sentence(error_of([&] {
                    smooth(path_of({{20, 20}, {100, 20}}), full).apply<Path>();
                  }),
                  "the truck cannot stand at the start (20.00, 20.00)");
  expect_sentence(error_of([&] {
                    smooth(path_of({{20, 20}, {100, 20}}), OccupancyGrid{}).apply<Path>();
                  }),
                  "the path leaves the map");
  expect_sentence(
      error_of([&] {
        smooth(path_of({{20, 20}, {100, 20}}), grid).set("wheelbase", 8.0).apply<Path>();
      }),
      "longer than the truck");
}

// Four right angles between walls, 600 m in all.
const Places kZigzag{{20, 20}, {195, 20}, {195, 62}, {20, 62}, {20, 110}, {195, 110}};

metric::DriveValidity judge_turning(const Path& path, const OccupancyGrid& grid, double radius) {
  metric::TruckLimits truck;
  truck.turning_radius = radius;
  return metric::check_drive(path, grid, nullptr, truck);
}

TEST(Smooth, OneSharpBendLeavesTheRestOfTheRouteSmooth) {
  // Wheels that take 40 m from straight to full lock can just round these corners on the move, one
  // by one: smoothing the whole route fails at one of them. Driven place by place in arcs, as it
  // was once, the truck stands 26 times; following smoothing where it goes astray, 11 times.
  const OccupancyGrid grid = roads_of(15, {kZigzag}, false);
  const Path path = smooth(path_of(kZigzag), grid).set("steering_distance", 40.0).apply<Path>();
  const auto found = judge_turning(path, grid, 12);
  EXPECT_EQ(found.violations(), 0U) << found.first;
  EXPECT_LE(found.standstills, 4U);
  const Path quick = smooth(path_of(kZigzag), grid).apply<Path>();
  EXPECT_EQ(judge_turning(quick, grid, 12).standstills, 0U);
}

TEST(Smooth, WarnsWhereTheTruckStandsOftenToTurnItsWheels) {
  const OccupancyGrid grid = roads_of(12, {kZigzag}, false);
  auto often = smooth(path_of(kZigzag), grid);
  const Path path = often.set("steering_distance", 40.0).set("turning_radius", 13.0).apply<Path>();
  const auto found = judge_turning(path, grid, 13);
  EXPECT_EQ(found.violations(), 0U) << found.first;
  EXPECT_EQ(found.cusps, 0U);
  ASSERT_GT(found.standstills, 7U);
  // The log counts what the validator counts.
  const std::string count = std::to_string(found.standstills);
  const auto& sentences = often.context().sentences;
  ASSERT_GE(sentences.size(), 2U);
  expect_sentence(sentences[sentences.size() - 2], "standstills: " + count + " (0 to change direc");
  expect_sentence(sentences.back(), "there are " + count + " standstills to turn the wheels, one");

  auto never = smooth(path_of(kZigzag), grid);
  never.apply<Path>();
  expect_sentence(never.context().sentences.back(), "no standstills");
}

TEST(Smooth, SaysThatAStraightRoadHasNoBend) {
  const OccupancyGrid grid = roads_of(16, {{{20, 20}, {150, 20}}});
  auto stage = smooth(path_of({{30, 20}, {140, 20}}), grid);
  stage.apply<Path>();
  expect_sentence(stage.context().sentences.back(), "drivable: 110.0 m, no bend, the outline");
}

TEST(Smooth, AllowedReversingChangesNothingWhereItCanGoForwards) {
  const OccupancyGrid grid = roads_of(16, {{{20, 60}, {180, 60}}, {{100, 10}, {100, 120}}}, false);
  const Path line = path_of({{100, 20}, {100, 60}, {30, 60}});
  const Path without = smooth(line, grid).apply<Path>();
  const Path with = smooth(line, grid).set("allow_reverse", true).apply<Path>();
  EXPECT_EQ(digest_of(without), digest_of(with));
}

TEST(Smooth, RefusesASizeThatIsNoTrucks) {
  const OccupancyGrid grid = roads_of(16, {{{20, 20}, {150, 20}}});
  const Path line = path_of({{20, 20}, {140, 20}});
  const auto refused = [&](const char* name, double value) {
    return error_of([&] { smooth(line, grid).set(name, value).apply<Path>(); });
  };
  expect_sentence(refused("turning_radius", 1e-4),
                  "turning_radius is 0.0001 m, but a truck 4.00 m wide and 9.00 m long cannot turn "
                  "with less than 2.00 m");
  EXPECT_FALSE(smooth(line, grid).set("turning_radius", 2.0).apply<Path>().points.empty());
}

TEST(Smooth, NamesNoObstacleWhereThereIsNone) {
  // Open ground: what is in the way is the route, no wall.
  OccupancyGrid grid = free_ground(420, 260);
  const Path line = path_of({{30, 30}, {180, 30}, {180, 60}, {30, 60}});
  const auto sentence = error_of([&] {
    smooth(line, grid).set("turning_radius", 1000.0).set("goal_heading", kPi).apply<Path>();
  });
  std::size_t at = sentence.find("obstacle at (");
  if (at == std::string::npos) {
    expect_sentence(sentence, "turn");
    return;
  }
  double x = 0, y = 0;
  ASSERT_EQ(std::sscanf(sentence.c_str() + at, "obstacle at (%lf, %lf)", &x, &y), 2) << sentence;
  // Only what lies off the map can be touched here.
  EXPECT_FALSE(grid.frame.cell_at(x, y)) << sentence;
}

TEST(Smooth, RepeatedPointsDoNotMatter) {
  const OccupancyGrid grid = roads_of(16, {{{20, 20}, {150, 20}}});
  const Path once = smooth(path_of({{20, 20}, {80, 20}, {140, 20}}), grid).apply<Path>();
  const Path twice =
      smooth(path_of({{20, 20}, {20, 20}, {80, 20}, {80, 20}, {140, 20}, {140, 20}}), grid)
          .apply<Path>();
  EXPECT_EQ(digest_of(once), digest_of(twice));
}

TEST(Smooth, EndsEarlierWhereThereIsNoRoom) {
  // The route leads to the very end of the road, where the truck's nose would stand in the wall.
  const OccupancyGrid grid = roads_of(16, {{{20, 20}, {150, 20}}}, false);
  auto stage = smooth(path_of({{30, 20}, {155, 20}}), grid);
  const Path path = stage.set("goal_tolerance", 10.0).apply<Path>();
  expect_drivable(path, grid);
  expect_sentence(stage.context().sentences.at(0), "the truck has no room at the route's end");
  expect_sentence(error_of([&] {
                    smooth(path_of({{30, 20}, {155, 20}}), grid)
                        .set("goal_heading", 0.0)
                        .set("goal_tolerance", 0.0)
                        .apply<Path>();
                  }),
                  "the truck cannot stand at the goal (155.00, 20.00)");
}

}  // namespace
}  // namespace stope::planner
