#include "plugins/topology/regions/region_grower.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "plugins/topology/regions/visit_convex.hpp"
#include "stope/random.hpp"

namespace stope::topology {
namespace {

PaddedGrid<std::uint8_t> open_where(std::int32_t width, std::int32_t height, auto&& open) {
  PaddedGrid<std::uint8_t> grid(width, height);
  std::fill_n(grid.data(), grid.size(), std::uint8_t{0});
  for (std::int32_t row = 0; row < height; ++row)
    for (std::int32_t column = 0; column < width; ++column)
      grid[grid.index(column, row)] = open(column, row) ? 1 : 0;
  return grid;
}

/// Algorithm 1 as one would write it down: every ray in full, every hull anew, every count by
/// looking at all points.
std::set<CellIndex> grow_plainly(const PaddedGrid<std::uint8_t>& open, CellIndex from,
                                 const GrowthRule& rule) {
  const std::int32_t x0 = open.column(from), y0 = open.row(from);
  RingTable rings;
  std::vector<HullPoint> qualified{{0, 0}}, failed;
  const auto is_open = [&](std::int32_t dx, std::int32_t dy) {
    const std::int32_t x = x0 + dx, y = y0 + dy;
    return x >= 0 && y >= 0 && x < open.width() && y < open.height() && open[open.index(x, y)];
  };
  double radius = rule.growth_radius;
  for (std::int32_t r = 1; r <= radius; ++r) {
    std::size_t added = 0;
    for (const CellOffset& cell : rings.ring(r)) {
      bool clear = is_open(cell.dx, cell.dy);
      const std::int32_t steps = std::max(std::abs(cell.dx), std::abs(cell.dy));
      for (std::int32_t i = 1; i < steps && clear; ++i) {
        const auto part = [&](int whole) {
          const int rounded = (2 * std::abs(whole) * i + steps) / (2 * steps);
          return whole < 0 ? -rounded : rounded;
        };
        clear = is_open(part(cell.dx), part(cell.dy));
      }
      const HullPoint point{cell.dx, cell.dy};
      if (clear) {
        std::vector<HullPoint> with = qualified;
        with.push_back(point);
        const auto hull = convex_hull(with);
        std::set<std::pair<int, int>> inside;
        visit_convex(hull, [&](int y, int first, int last) {
          for (int x = first; x <= last; ++x) inside.insert({x, y});
        });
        const auto count = std::count_if(failed.begin(), failed.end(), [&](const HullPoint& p) {
          return inside.count({p.x, p.y}) > 0;
        });
        // A point in the hull of the others changes nothing and is taken.
        const auto before = convex_hull(qualified);
        bool held = false;
        visit_convex(before, [&](int y, int first, int last) {
          held = held || (y == point.y && first <= point.x && point.x <= last);
        });
        clear = held || static_cast<double>(count) <=
                            rule.obstacle_ratio * static_cast<double>(with.size());
      }
      (clear ? qualified : failed).push_back(point);
      added += clear ? 1 : 0;
    }
    if (static_cast<double>(added) <
        rule.addition_ratio * static_cast<double>(rings.ring(r).size()))
      break;
    const double pass =
        static_cast<double>(qualified.size()) / static_cast<double>(rings.cells_within(r));
    radius = std::min(rule.max_radius, radius + rule.radius_weight * pass * radius);
  }
  std::set<CellIndex> cells;
  for (const HullPoint& point : qualified) cells.insert(open.index(x0 + point.x, y0 + point.y));
  return cells;
}

/// Those that a walk over them from the growth point reaches.
std::set<CellIndex> connected(const std::set<CellIndex>& cells, CellIndex from, CellIndex stride) {
  std::set<CellIndex> reached{from};
  std::vector<CellIndex> open{from};
  while (!open.empty()) {
    const CellIndex cell = open.back();
    open.pop_back();
    for (const CellIndex step : {1, -1, 0})
      for (const CellIndex row : {stride, -stride, 0})
        if (cells.count(cell + step + row) && reached.insert(cell + step + row).second)
          open.push_back(cell + step + row);
  }
  return reached;
}

TEST(RegionGrower, EqualsThePlainAlgorithm) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Random random(seed);
    const double share = random.uniform(0.0, 0.1);
    const auto grid = open_where(40, 34, [&](int, int) { return random.uniform() >= share; });
    GrowthRule rule;
    rule.growth_radius = random.uniform(1, 8);
    rule.max_radius = random.uniform(8, 20);
    rule.addition_ratio = random.uniform(0.1, 0.6);
    rule.obstacle_ratio = random.uniform(0, 0.1);
    RegionGrower grower(rule);
    for (int i = 0; i < 3; ++i) {  // the grower is used again, and must have forgotten
      const CellIndex from = grid.index(static_cast<std::int32_t>(random.below(40)),
                                        static_cast<std::int32_t>(random.below(34)));
      if (!grid[from]) continue;
      const Growth growth = grower.grow(grid, from);
      const std::set<CellIndex> cells(growth.cells.begin(), growth.cells.end());
      EXPECT_EQ(cells.size(), growth.cells.size());
      ASSERT_EQ(cells, connected(grow_plainly(grid, from, rule), from, grid.stride()))
          << "seed " << seed;
    }
  }
}

TEST(RegionGrower, InTheOpenIsADiscOfTheLargestRadius) {
  const auto grid = open_where(101, 101, [](int, int) { return true; });
  GrowthRule rule;
  rule.growth_radius = 6;
  rule.max_radius = 20;
  const Growth growth = RegionGrower(rule).grow(grid, grid.index(50, 50));
  EXPECT_EQ(growth.cells.size(), RingTable().cells_within(20));
  EXPECT_EQ(growth.scanned, 20);
}

// Equation 1 only ever enlarges the radius, so in the paper a growth in the open ends at the map's
// border, or where a ring adds too little.
TEST(RegionGrower, AsPrintedHasNoBound) {
  const auto grid = open_where(101, 101, [](int, int) { return true; });
  GrowthRule rule;
  rule.growth_radius = 6;
  rule.max_radius = 20;
  rule.as_printed = true;
  EXPECT_GT(RegionGrower(rule).grow(grid, grid.index(50, 50)).scanned, 50);
}

// Lines 19 and 20 of Algorithm 1 add the whole ring.
TEST(RegionGrower, AsPrintedTakesObstaclesIn) {
  const auto grid = open_where(41, 41, [](int x, int y) { return x != 23 || y != 20; });
  GrowthRule rule;
  rule.growth_radius = 8;
  rule.as_printed = true;
  rule.radius_weight = 0;
  const Growth growth = RegionGrower(rule).grow(grid, grid.index(20, 20));
  EXPECT_EQ(growth.cells.size(), RingTable().cells_within(7));
  rule.as_printed = false;
  EXPECT_LT(RegionGrower(rule).grow(grid, grid.index(20, 20)).cells.size(),
            RingTable().cells_within(8));
}

// A door in a wall: with r_o = 0 nothing behind the wall is taken.
TEST(RegionGrower, TheObstacleRatioKeepsItOutOfTheNextRoom) {
  const auto grid = open_where(61, 41, [](int x, int y) { return x != 30 || (y > 17 && y < 23); });
  GrowthRule rule;
  rule.growth_radius = rule.max_radius = 25;
  rule.addition_ratio = 0.05;
  rule.obstacle_ratio = 0;
  const auto beyond = [&](const Growth& growth) {
    return std::count_if(growth.cells.begin(), growth.cells.end(),
                         [&](CellIndex cell) { return grid.column(cell) > 31; });
  };
  EXPECT_LE(beyond(RegionGrower(rule).grow(grid, grid.index(14, 20))), 3);
  rule.obstacle_ratio = 0.5;
  EXPECT_GT(beyond(RegionGrower(rule).grow(grid, grid.index(14, 20))), 20);
}

}  // namespace
}  // namespace stope::topology
