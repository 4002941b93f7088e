#include "plugins/metric/drive_validity.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "stope/error.hpp"
#include "tests/plugins/stage_harness.hpp"

extern "C" const stope::StageEntry* stope_stage_Drivable();

namespace stope::metric {
namespace {

// 100 x 100 m of free ground around the origin.
OccupancyGrid open_ground() {
  OccupancyGrid grid;
  grid.frame = {200, 200, 0.5, {-50, -50, 0}};
  grid.cells.assign(grid.frame.size(), OccupancyGrid::kFree);
  return grid;
}

void block(OccupancyGrid& grid, double x, double y, std::uint8_t value = OccupancyGrid::kOccupied) {
  grid.cells[grid.frame.place(*grid.frame.cell_at(x, y))] = value;
}

Path straight(double from, double to, double y = 0) {
  Path path;
  for (double x = from; x <= to + 1e-9; x += 0.5) path.points.push_back({x, y, 0, 0, 0, 0, 5});
  return path;
}

// To the left from the origin, by angle.
Path arc(double radius, double angle) {
  Path path;
  const double count = std::ceil(radius * angle / 0.5);
  for (double i = 0; i <= count; ++i) {
    const double a = angle * i / count;
    path.points.push_back(
        {radius * std::sin(a), radius * (1 - std::cos(a)), 0, a, 0, 1 / radius, 3});
  }
  return path;
}

DriveValidity judge(const Path& path, const OccupancyGrid& grid = open_ground(),
                    double margin = 0) {
  TruckLimits truck;
  truck.margin = margin;
  return check_drive(path, grid, nullptr, truck);
}

TEST(DriveValidity, AStraightAndAWideArcAreFine) {
  EXPECT_EQ(judge(straight(-20, 20)).violations(), 0U);
  const DriveValidity found = judge(arc(12, 2));
  EXPECT_EQ(found.violations(), 0U) << found.first;
  EXPECT_NEAR(found.length, 24, 1e-9);
  EXPECT_NEAR(found.least_radius, 12, 1e-6);
  EXPECT_NEAR(found.lateral_acceleration, 9.0 / 12, 1e-9);
}

TEST(DriveValidity, ATightArcIsATurnViolation) {
  const DriveValidity found = judge(arc(11.9, 2));
  EXPECT_GT(found.turns, 40U);
  EXPECT_NE(found.first.find("a radius of 11.90 m, the truck needs 12.00 m"), std::string::npos)
      << found.first;
}

TEST(DriveValidity, ATightBendIsFoundFromPositionsAloneToo) {
  Path path = arc(8, 2);
  for (PathPoint& point : path.points) point.yaw *= 0.6, point.curvature *= 0.6;
  EXPECT_GT(judge(path).turns, 10U);
}

TEST(DriveValidity, ACornerAndASlidingTruckAreFound) {
  Path corner = straight(-20, 0);
  for (double y = 0.5; y < 10; y += 0.5)
    corner.points.push_back({0, y, 0, std::numbers::pi / 2, 0, 0, 5});
  EXPECT_GT(judge(corner).turns + judge(corner).headings, 0U);
  Path sliding = straight(-20, 20);
  for (PathPoint& point : sliding.points) point.yaw = 0.02;
  EXPECT_GT(judge(sliding).headings, 70U);
  Path gap = straight(-20, 20);
  gap.points.erase(gap.points.begin() + 10, gap.points.begin() + 13);
  EXPECT_EQ(judge(gap).headings, 1U);
}

TEST(DriveValidity, ClearanceIsThatOfTheOutline) {
  // The outline reaches from 2.5 m behind to 6.5 m ahead and 2 m to the sides.
  OccupancyGrid grid = open_ground();
  block(grid, 0.1, 3.1);  // the square from (0, 3) to (0.5, 3.5)
  EXPECT_NEAR(judge(straight(-20, 20), grid).least_clearance, 1, 1e-9);
  EXPECT_EQ(judge(straight(-20, 20), grid, 0.99).violations(), 0U);
  EXPECT_GT(judge(straight(-20, 20), grid, 1.01).touches, 0U);
  block(grid, 27.6, 0.1, OccupancyGrid::kUnknown);
  EXPECT_NEAR(judge(straight(-20, 20), grid).least_clearance, 1, 1e-9);
  EXPECT_NEAR(judge(straight(-20, 20.5), grid).least_clearance, 0.5, 1e-9);
  EXPECT_GT(judge(straight(-20, 21.5), grid).touches, 0U);
}

TEST(DriveValidity, ANoseThatSwingsOutIsSeen) {
  // At rest of a left arc of 12 m the front right corner runs on a circle of this radius.
  const double outer = std::hypot(12 + 2, 6.5);
  for (const double beyond : {0.05, -0.6}) {
    OccupancyGrid grid = open_ground();
    const double angle = 1, reach = outer + beyond + 0.36;  // half a diagonal, the cell's centre
    block(grid, reach * std::sin(angle), 12 - reach * std::cos(angle));
    EXPECT_EQ(judge(arc(12, 2), grid).touches > 0, beyond < 0) << beyond;
  }
}

TEST(DriveValidity, TheMapsEdgeIsAnObstacle) {
  EXPECT_GT(judge(straight(-20, 44.5)).touches, 0U);
  EXPECT_EQ(judge(straight(-20, 43)).touches, 0U);
  EXPECT_GT(judge(straight(-47.6, 0)).touches, 0U);
}

TEST(DriveValidity, SlopesAreMeasuredBetweenTheAxles) {
  ElevationGrid elevation{open_ground().frame, {}, {}};
  for (std::int32_t row = 0; row < 200; ++row) {
    for (std::int32_t column = 0; column < 200; ++column) {
      const Vector2 centre = elevation.frame.centre({column, row});
      elevation.cells.push_back(static_cast<float>(0.1 * centre.x() + 0.05 * centre.y()));
    }
  }
  const auto slope = [&](const Path& path, double most) {
    TruckLimits truck;
    truck.max_grade = most;
    return check_drive(path, open_ground(), &elevation, truck);
  };
  EXPECT_NEAR(slope(straight(-20, 20), 0.12).steepest, 0.1, 1e-5);
  EXPECT_EQ(slope(straight(-20, 20), 0.12).slopes, 0U);
  EXPECT_GT(slope(straight(-20, 20), 0.099).slopes, 0U);
  // Along the fall line of the plane it is steeper.
  EXPECT_NEAR(slope(arc(12, 1), 0.12).steepest, std::hypot(0.1, 0.05), 1e-3);
  elevation.cells[elevation.frame.place(*elevation.frame.cell_at(10, 0))] = std::nanf("");
  EXPECT_GT(slope(straight(-20, 20), 0.12).slopes, 0U);
}

TEST(DriveValidity, BackwardsIsJudgedAlike) {
  Path path = arc(12, 1);
  std::reverse(path.points.begin(), path.points.end());
  for (PathPoint& point : path.points) point.speed = -2;
  EXPECT_EQ(judge(path).violations(), 0U) << judge(path).first;
  Path there_and_back = arc(12, 1);
  there_and_back.points.back().speed = 0;
  there_and_back.points.insert(there_and_back.points.end(), path.points.begin() + 1,
                               path.points.end());
  EXPECT_EQ(judge(there_and_back).violations(), 0U) << judge(there_and_back).first;
  EXPECT_EQ(judge(there_and_back).cusps, 1U);
}

TEST(DriveValidity, WhatThePointsStateMustBeTrue) {
  Path path = arc(15, 1);
  path.points[7].curvature = 1.0 / 15 + 0.006;
  EXPECT_EQ(judge(path).statements, 1U);
  path = arc(15, 1);
  path.points[7].speed = -1;
  EXPECT_EQ(judge(path).statements, 1U);
}

TEST(DriveValidity, CountsWhereTheTruckStandsOnTheWay) {
  Path path = straight(0, 20);
  EXPECT_EQ(judge(path).standstills, 0U);
  path.points.front().speed = path.points.back().speed = 0;
  EXPECT_EQ(judge(path).standstills, 0U);
  path.points[7].speed = path.points[8].speed = 0;  // one stop
  path.points[20].speed = 0;
  EXPECT_EQ(judge(path).standstills, 2U);
  for (PathPoint& point : path.points) point.speed = 0;  // none planned
  EXPECT_EQ(judge(path).standstills, 0U);
}

TEST(DriveValidity, KeepsThePlannersMarginUnlessToldOtherwise) {
  // Of smooth and reeds_shepp: a path that they give passes without a word about margins.
  EXPECT_EQ(TruckLimits().margin, 0.5);
}

TEST(DriveValidity, RefusesWhatIsNoPath) {
  const auto sentence = [](const Path& path) { return testing::error_of([&] { judge(path); }); };
  EXPECT_NE(sentence({}).find("has 0 points"), std::string::npos);
  Path path = straight(0, 10);
  path.points[3].yaw = std::nan("");
  EXPECT_NE(sentence(path).find("point 3 of the path has no finite"), std::string::npos);
}

TEST(DriveValidity, TheStageSaysWhatTheMeasureFound) {
  testing::StageHarness stage(stope_stage_Drivable());
  const auto measures = stage.input("path", arc(11, 1))
                            .input("grid", open_ground())
                            .set("goal", std::vector<double>{5, 0, 15, 0, 15, 15, 5, 15})
                            .apply<Measures>();
  const auto value = [&](const std::string& name) {
    for (std::size_t i = 0; i < measures.names.size(); ++i)
      if (measures.names[i] == name) return measures.values[i];
    return std::nan("");
  };
  EXPECT_EQ(value("drivable"), 0);
  EXPECT_GT(value("turn_violations"), 0);
  EXPECT_EQ(value("footprint_violations"), 0);
  EXPECT_NEAR(value("least_radius"), 11, 1e-6);
  EXPECT_EQ(value("reaches_goal"), 1);
  EXPECT_NE(stage.context().sentences.at(0).find("cannot be driven"), std::string::npos);
}

}  // namespace
}  // namespace stope::metric
