#include "plugins/topology/regions/growing_hull.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "plugins/topology/regions/blocked_slopes.hpp"
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

TEST(RingTable, TheRingsAreEveryCellOnceByDistanceAndSlope) {
  RingTable rings;
  Cells seen;
  for (std::int32_t r = 0; r <= 40; ++r) {
    const auto octant = rings.octant(r);
    const std::size_t before = seen.size();
    for (std::size_t i = 0; i < octant.size(); ++i) {
      const int along = octant[i].along, aside = octant[i].aside;
      EXPECT_LE(aside, along);
      EXPECT_EQ(std::lround(std::hypot(along, aside)), r);
      if (i > 0) {
        EXPECT_GT(octant[i].slope, octant[i - 1].slope);
        EXPECT_GT(aside * octant[i - 1].along, octant[i - 1].aside * along);
      }
      for (const int x : {along, -along})
        for (const int y : {aside, -aside}) seen.insert({x, y}), seen.insert({y, x});
    }
    EXPECT_EQ(rings.cells_in(r), seen.size() - before);
    EXPECT_EQ(rings.cells_within(r), seen.size());
  }
  for (int y = -40; y <= 40; ++y) {
    for (int x = -40; x <= 40; ++x) {
      EXPECT_EQ(seen.count({x, y}), std::lround(std::hypot(x, y)) <= 40 ? 1U : 0U)
          << x << ", " << y;
      EXPECT_EQ(std::abs(x) <= disc_reach(40, y), seen.count({x, y}) > 0) << x << ", " << y;
    }
  }
}

// The blocked rays are those that a walk over all their cells finds blocked.
TEST(BlockedSlopes, AreThoseOfTheRaysThroughBlockedCells) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Random random(seed);
    BlockedSlopes slopes;
    slopes.clear(1);
    Cells blocked;
    const std::size_t octant = random.below(8);
    std::uint32_t along = 1;
    for (std::uint64_t i = random.below(60) + 1; i-- > 0;) {
      along += static_cast<std::uint32_t>(random.below(seed % 2 == 0 ? 2 : 8));
      const auto aside = static_cast<std::uint32_t>(random.below(along + 1));
      slopes.reach(static_cast<std::int32_t>(along));
      slopes.block(octant, along, aside);
      blocked.insert({static_cast<int>(along), static_cast<int>(aside)});
    }
    const auto bins = slopes.bins(octant);
    for (int steps = static_cast<int>(along) + 1; steps < static_cast<int>(along) + 90; ++steps) {
      for (int minor = 0; minor <= steps; ++minor) {
        bool is_blocked = false;
        for (int i = 1; i < steps; ++i)
          is_blocked = is_blocked || blocked.count({i, (2 * i * minor + steps) / (2 * steps)}) > 0;
        ASSERT_EQ(bins.block(ray_slope(static_cast<std::uint64_t>(minor),
                                       static_cast<std::uint64_t>(steps))),
                  is_blocked)
            << "seed " << seed << ", " << minor << " / " << steps;
      }
    }
  }
}

TEST(ConvexHull, OfKnownPoints) {
  EXPECT_EQ(convex_hull({{2, 3}}), (std::vector<HullPoint>{{2, 3}}));
  EXPECT_EQ(convex_hull({{0, 0}, {2, 2}, {1, 1}, {0, 0}}),
            (std::vector<HullPoint>{{0, 0}, {2, 2}}));
  EXPECT_EQ(convex_hull({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {2, 0}, {1, 3}}),
            (std::vector<HullPoint>{{0, 0}, {4, 0}, {4, 4}, {0, 4}}));
}

TEST(ConvexHull, OfTwoHullsIsThatOfAllTheirPoints) {
  Random random(3);
  const auto draw = [&] {
    std::vector<HullPoint> points;
    const std::uint64_t count = random.below(10);
    for (std::uint64_t i = 0; i <= count; ++i)
      points.push_back(
          {static_cast<std::int32_t>(random.below(8)), static_cast<std::int32_t>(random.below(8))});
    return points;
  };
  for (int run = 0; run < 3000; ++run) {
    std::vector<HullPoint> a = draw();
    const std::vector<HullPoint> b = draw();
    const std::vector<HullPoint> joined = joined_hull(convex_hull(a), convex_hull(b));
    a.insert(a.end(), b.begin(), b.end());
    EXPECT_EQ(joined, convex_hull(a)) << "run " << run;
  }
}

TEST(GrowingHull, HoldsWhatTheHullOfAllPointsHolds) {
  constexpr int kMost = 7;
  const auto held_cells = [&](const auto& holds) {
    Cells cells;
    for (int y = -kMost; y <= kMost; ++y)
      for (int x = -kMost; x <= kMost; ++x)
        if (holds(HullPoint{x, y})) cells.insert({x, y});
    return cells;
  };
  GrowingHull hull;  // used again
  hull.reach(kMost);
  for (std::uint64_t seed = 0; seed < 80; ++seed) {
    Random random(seed);
    const auto coordinate = [&] {
      return static_cast<std::int32_t>(random.below(2 * kMost + 1)) - kMost;
    };
    const auto radius = static_cast<std::int32_t>(random.below(3));
    std::vector<HullPoint> points{{0, 0}};
    for (int y = -radius; y <= radius; ++y)
      for (int x = -radius; x <= radius; ++x)
        if (std::lround(std::hypot(x, y)) == radius) points.push_back({x, y});
    hull.start(radius);
    Cells held = held_cells([&](const HullPoint& cell) { return in_hull(points, cell); });
    for (int step = 0; step < 14; ++step) {
      HullPoint point{coordinate(), coordinate()};
      if (seed % 3 == 0 && step < 5) point = {point.x, point.x};  // on a line at first
      const bool outside = !in_hull(points, point);
      ASSERT_EQ(hull.holds(point), !outside) << "seed " << seed << ", step " << step;
      if (!outside) continue;
      points.push_back(point);
      const Cells now = held_cells([&](const HullPoint& cell) { return in_hull(points, cell); });
      GrowingHull::Addition addition = hull.see(point);
      if (addition.is_alone) {
        EXPECT_EQ(now.size(), held.size() + 1);
      } else {
        Cells added;
        hull.take_cells(point, addition, [&](int y, int first, int last) {
          for (int x = first; x <= last; ++x)
            EXPECT_TRUE(added.insert({x, y}).second) << "seed " << seed << ", step " << step;
        });
        if (random.below(3) == 0) {
          hull.give_back();
          points.pop_back();
          ASSERT_EQ(held_cells([&](const HullPoint& cell) { return hull.holds(cell); }), held);
          continue;
        }
        added.insert(held.begin(), held.end());
        ASSERT_EQ(added, now) << "seed " << seed << ", step " << step;
      }
      hull.add(point, addition);
      held = now;
      ASSERT_EQ(held_cells([&](const HullPoint& cell) { return hull.holds(cell); }), now)
          << "seed " << seed << ", step " << step;
      ASSERT_EQ(cells_in(hull.corners()), now) << "seed " << seed << ", step " << step;
    }
  }
}

}  // namespace
}  // namespace stope::topology
