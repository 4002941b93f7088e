#include "plugins/topology/road_exits.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace stope::topology {
namespace {

constexpr LinePoint kJunction{0, 0, 10};

/// A road of even width from the junction on, along a circle of `radius` to the left, in steps of
/// one cell, as wide at its begin as the junction.
std::vector<LinePoint> arc(double heading, double radius, double length) {
  std::vector<LinePoint> points;
  for (double way = 0; way <= length; way += 1) {
    const double turned = heading + way / radius;
    points.push_back({radius * (std::sin(turned) - std::sin(heading)),
                      radius * (std::cos(heading) - std::cos(turned)), way < 10 ? 10.0 : 8.0});
  }
  return points;
}

RoadExit exit_of(const std::vector<LinePoint>& points) {
  const std::vector<RoadEnd> ends{{CourseView(points, false), length_of(points), 0}};
  return find_exit(ends, 0, kJunction, 2.2);
}

RoadExit exit_at(double x, double y, double heading) {
  RoadExit exit;
  exit.place = {x, y, 8};
  exit.dx = std::cos(heading);
  exit.dy = std::sin(heading);
  exit.directed = true;
  return exit;
}

TEST(RoadExits, ARoadIsItselfAgainWhereItIsAsNarrowAsItGets) {
  const RoadExit exit = exit_of(arc(0, 1e9, 100));
  EXPECT_EQ(exit.index, 10U);  // where this road stops being as wide as the junction
  EXPECT_TRUE(exit.directed);
  EXPECT_NEAR(exit.dx, 1, 1e-6);
}

TEST(RoadExits, CurvatureIsThatOfTheCircleTheRoadFollows) {
  for (const double radius : {60.0, -60.0, 200.0, -200.0}) {
    const RoadExit exit = exit_of(arc(0.5, radius, 120));
    const double way = static_cast<double>(exit.index);
    // A parabola over two clearances of an arc of 60 m leaves a third-order error below 3 %.
    EXPECT_NEAR(exit.curvature, 1 / radius, 0.03 / std::abs(radius));
    EXPECT_NEAR(std::atan2(exit.dy, exit.dx), 0.5 + way / radius, 0.005);
  }
}

TEST(RoadExits, AShortRoadHasNoDirection) { EXPECT_FALSE(exit_of(arc(0, 1e6, 12)).directed); }

TEST(RoadExits, RoadsOnOneLineContinueEachOtherAndRoadsAtRightAnglesDoNot) {
  const double pi = std::numbers::pi;
  const RoadExit east = exit_at(10, 0, 0), west = exit_at(-10, 0, pi),
                 north = exit_at(0, 10, pi / 2);
  EXPECT_NEAR(mismatch(east, west), 0, 1e-9);
  EXPECT_NEAR(turn_between(east, west), 0, 1e-9);
  EXPECT_NEAR(turn_between(east, north), pi / 2, 1e-9);
  EXPECT_NEAR(mismatch(east, north), pi / 2, 1e-9);
}

TEST(RoadExits, RoadsOnOneCircleContinueEachOther) {
  const double radius = 60;
  // The junction lies at the circle's lowest point; the way out to the west turns to the right.
  const RoadExit east = exit_of(arc(0, radius, 120));
  const RoadExit west = exit_of(arc(std::numbers::pi, -radius, 120));
  EXPECT_LT(mismatch(west, east), 0.02);
  const double way = static_cast<double>(east.index + west.index);
  EXPECT_NEAR(turn_between(west, east), way / radius, 0.01);
}

TEST(RoadExits, TheCrossingLiesWhereStraightRoadsMeet) {
  const double pi = std::numbers::pi;
  // Three roads whose lines meet in (2, -1); a weak pull holds the old place, (0, 0).
  const std::vector<RoadExit> exits{exit_at(12, -1, 0), exit_at(2, 9, pi / 2),
                                    exit_at(2 - 7, -1 - 7, -3 * pi / 4)};
  const LinePoint place = crossing_of(exits, kJunction);
  EXPECT_NEAR(place.x, 2, 0.1);
  EXPECT_NEAR(place.y, -1, 0.1);
  EXPECT_NEAR(place.distance, 10 - std::hypot(place.x, place.y), 1e-12);
}

TEST(RoadExits, TheCrossingStaysInTheJunction) {
  const double pi = std::numbers::pi;
  const std::vector<RoadExit> exits{exit_at(10, 20, 0), exit_at(-10, 20, pi),
                                    exit_at(30, 5, pi / 2)};
  const LinePoint place = crossing_of(exits, kJunction);
  EXPECT_NEAR(std::hypot(place.x, place.y), 5, 1e-9);
}

}  // namespace
}  // namespace stope::topology
