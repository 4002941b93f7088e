#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "plugins/topology/regions/ring_table.hpp"
#include "plugins/topology/regions/visit_convex.hpp"
#include "stope/random.hpp"

namespace stope::topology {
namespace {

using Cells = std::set<std::pair<int, int>>;

/// Cells of which no line through two of the points has all points strictly on the other side.
bool in_hull(const std::vector<HullPoint>& points, const HullPoint& cell) {
  for (const HullPoint& a : points) {
    for (const HullPoint& b : points) {
      if (a == b) continue;
      bool all_left = true;
      for (const HullPoint& c : points) all_left = all_left && cross(a, b, c) >= 0;
      if (all_left && cross(a, b, cell) < 0) return false;
      // Points on one line: the hull ends where they end.
      bool all_on = true;
      for (const HullPoint& c : points) all_on = all_on && cross(a, b, c) == 0;
      if (all_on &&
          std::all_of(points.begin(), points.end(),
                      [&](const HullPoint& c) {
                        return (c.x - a.x) * (b.x - a.x) + (c.y - a.y) * (b.y - a.y) >= 0;
                      }) &&
          (cell.x - a.x) * (b.x - a.x) + (cell.y - a.y) * (b.y - a.y) < 0)
        return false;
    }
  }
  const bool one = std::all_of(points.begin(), points.end(),
                               [&](const HullPoint& point) { return point == points[0]; });
  return !one || cell == points[0];
}

Cells cells_in(const std::vector<HullPoint>& corners) {
  Cells cells;
  visit_convex(corners, [&](int y, int first, int last) {
    for (int x = first; x <= last; ++x) cells.insert({x, y});
  });
  return cells;
}

TEST(RingTable, TheRingsAreEveryCellOnceByDistanceAndAngle) {
  RingTable rings;
  Cells seen;
  for (std::int32_t r = 0; r <= 40; ++r) {
    double last = -1;
    for (const CellOffset& cell : rings.ring(r)) {
      EXPECT_TRUE(seen.insert({cell.dx, cell.dy}).second);
      EXPECT_EQ(std::lround(std::hypot(cell.dx, cell.dy)), r);
      double angle = std::atan2(cell.dy, cell.dx);
      if (angle < 0) angle += 2 * 3.14159265358979;
      EXPECT_GE(angle, last);
      last = angle;
    }
    EXPECT_EQ(rings.cells_within(r), seen.size());
  }
  for (int y = -28; y <= 28; ++y)
    for (int x = -28; x <= 28; ++x) EXPECT_TRUE(seen.count({x, y})) << x << ", " << y;
}

TEST(ConvexHull, OfKnownPoints) {
  EXPECT_EQ(convex_hull({{2, 3}}), (std::vector<HullPoint>{{2, 3}}));
  EXPECT_EQ(convex_hull({{0, 0}, {2, 2}, {1, 1}, {0, 0}}),
            (std::vector<HullPoint>{{0, 0}, {2, 2}}));
  EXPECT_EQ(convex_hull({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 0}, {1, 3}}),
            (std::vector<HullPoint>{{0, 0}, {4, 0}, {4, 4}, {0, 4}}));
}

TEST(GrowingHull, HoldsWhatTheHullOfAllPointsHolds) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    Random random(seed);
    const auto coordinate = [&] { return static_cast<std::int32_t>(random.below(13)) - 6; };
    std::vector<HullPoint> points{{coordinate(), coordinate()}};
    GrowingHull hull;
    hull.start(points);
    Cells held = cells_in(hull.corners());
    for (int step = 0; step < 12; ++step) {
      const HullPoint point{coordinate(), coordinate()};
      GrowingHull::Addition addition;
      const bool outside = !in_hull(points, point);
      ASSERT_EQ(hull.see(point, addition), outside) << "seed " << seed << ", step " << step;
      if (outside) {
        for (const auto& cell : cells_in({addition.triangle.begin(), addition.triangle.end()}))
          held.insert(cell);
        hull.add(point, addition);
      }
      points.push_back(point);
      Cells expected;
      for (int y = -6; y <= 6; ++y)
        for (int x = -6; x <= 6; ++x)
          if (in_hull(points, {x, y})) expected.insert({x, y});
      ASSERT_EQ(held, expected) << "seed " << seed << ", step " << step;
      ASSERT_EQ(cells_in(hull.corners()), expected) << "seed " << seed << ", step " << step;
    }
  }
}

}  // namespace
}  // namespace stope::topology
