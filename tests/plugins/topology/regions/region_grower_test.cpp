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

/// The cells whose distance rounds to each radius, by angle.
std::vector<std::vector<HullPoint>> plain_rings(std::int32_t most) {
  std::vector<std::vector<HullPoint>> rings(static_cast<std::size_t>(most) + 1);
  for (std::int32_t y = -most; y <= most; ++y)
    for (std::int32_t x = -most; x <= most; ++x)
      if (const auto r = std::lround(std::hypot(x, y)); r <= most)
        rings[static_cast<std::size_t>(r)].push_back({x, y});
  const auto angle = [](const HullPoint& cell) {
    const double angle = std::atan2(cell.y, cell.x);
    return angle < 0 ? angle + 2 * 3.14159265358979323846 : angle;
  };
  for (auto& ring : rings)
    std::sort(ring.begin(), ring.end(),
              [&](const HullPoint& a, const HullPoint& b) { return angle(a) < angle(b); });
  return rings;
}

bool held_by(const std::vector<HullPoint>& corners, const HullPoint& point) {
  bool held = false;
  visit_convex(corners, [&](std::int32_t y, std::int32_t first, std::int32_t last) {
    held = held || (y == point.y && first <= point.x && point.x <= last);
  });
  return held;
}

struct PlainGrowth {
  std::set<CellIndex> cells;
  std::int32_t scanned = 0;
};

/// Algorithm 1 as one would write it down: every ray in full, every hull anew, every count by
/// looking at all points.
PlainGrowth grow_plainly(const PaddedGrid<std::uint8_t>& open, CellIndex from,
                         const GrowthRule& rule) {
  const std::int32_t x0 = open.column(from), y0 = open.row(from);
  const double bound = rule.as_printed ? std::hypot(open.width(), open.height()) : rule.max_radius;
  const auto most = static_cast<std::int32_t>(bound) + 1;
  const auto rings = plain_rings(most);
  const auto on_map = [&](std::int32_t dx, std::int32_t dy) {
    return x0 + dx >= 0 && y0 + dy >= 0 && x0 + dx < open.width() && y0 + dy < open.height();
  };
  const auto is_open = [&](std::int32_t dx, std::int32_t dy) {
    return on_map(dx, dy) && open[open.index(x0 + dx, y0 + dy)];
  };
  std::vector<std::uint8_t> failed(static_cast<std::size_t>((2 * most + 1) * (2 * most + 1)), 0);
  const auto has_failed = [&](std::int32_t dx, std::int32_t dy) -> std::uint8_t& {
    return failed[static_cast<std::size_t>((dy + most) * (2 * most + 1) + dx + most)];
  };
  std::vector<HullPoint> corners{{0, 0}};  // of the hull of the points that qualified
  PlainGrowth growth;
  growth.cells.insert(from);
  std::size_t within = 1;
  double radius = std::min(rule.growth_radius, bound);
  for (std::int32_t r = 1; rule.as_printed ? r < radius : r <= radius; ++r) {
    const auto& ring = rings[static_cast<std::size_t>(r)];
    growth.scanned = r;
    within += ring.size();
    std::size_t qualified = 0;
    const std::size_t before = growth.cells.size();
    for (const HullPoint& cell : ring) {
      bool clear = is_open(cell.x, cell.y);
      const std::int32_t steps = std::max(std::abs(cell.x), std::abs(cell.y));
      for (std::int32_t i = 1; i < steps && clear; ++i) {
        const auto part = [&](int whole) {
          const int rounded = (2 * std::abs(whole) * i + steps) / (2 * steps);
          return whole < 0 ? -rounded : rounded;
        };
        clear = is_open(part(cell.x), part(cell.y));
      }
      if (clear && !held_by(corners, cell)) {
        std::vector<HullPoint> with = corners;
        with.push_back(cell);
        with = convex_hull(with);
        std::size_t count = 0;
        visit_convex(with, [&](std::int32_t y, std::int32_t first, std::int32_t last) {
          for (std::int32_t x = first; x <= last; ++x) count += has_failed(x, y);
        });
        const double share = rule.as_printed ? rule.addition_ratio : rule.obstacle_ratio;
        clear = static_cast<double>(count) <=
                share * static_cast<double>(before + (rule.as_printed ? 0 : qualified) + 1);
        if (clear) corners = with;
      }
      has_failed(cell.x, cell.y) = clear ? 0 : 1;
      qualified += clear ? 1 : 0;
      if (rule.as_printed ? on_map(cell.x, cell.y) : clear)
        growth.cells.insert(open.index(x0 + cell.x, y0 + cell.y));
    }
    if (static_cast<double>(qualified) < rule.addition_ratio * static_cast<double>(ring.size()))
      break;
    const double pass = static_cast<double>(growth.cells.size()) / static_cast<double>(within);
    radius = std::min(bound, radius + rule.radius_weight * pass * radius);
  }
  return growth;
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

std::set<CellIndex> cells_of(const Growth& growth) {
  std::set<CellIndex> cells;
  for (const CellRun& run : growth.runs)
    for (CellIndex cell = run.first; cell < run.end(); ++cell) cells.insert(cell);
  return cells;
}

void expect_plain_growth(const PaddedGrid<std::uint8_t>& grid, CellIndex from,
                         const GrowthRule& rule, RegionGrower& grower) {
  const Growth growth = grower.grow(grid, from);
  PlainGrowth plain = grow_plainly(grid, from, rule);
  if (!rule.as_printed) plain.cells = connected(plain.cells, from, grid.stride());
  EXPECT_EQ(growth.scanned, plain.scanned);
  EXPECT_EQ(count_cells(growth.runs), plain.cells.size());
  EXPECT_EQ(cells_of(growth), plain.cells);
  for (std::size_t i = 1; i < growth.runs.size(); ++i)
    EXPECT_LT(growth.runs[i - 1].end(), growth.runs[i].first);
}

GrowthRule any_rule(double most, bool as_printed, Random& random) {
  GrowthRule rule;
  rule.growth_radius = random.uniform(1, most / 2);
  rule.max_radius = random.uniform(most / 2, most);
  rule.addition_ratio = random.uniform(0.05, 0.6);
  rule.obstacle_ratio = random.uniform(0, 0.1);
  rule.as_printed = as_printed;
  return rule;
}

TEST(RegionGrower, EqualsThePlainAlgorithm) {
  for (std::uint64_t seed = 0; seed < 80; ++seed) {
    Random random(seed);
    const double share = random.uniform(0.0, 0.1);
    const auto grid = open_where(40, 34, [&](int, int) { return random.uniform() >= share; });
    const GrowthRule rule = any_rule(20, seed % 2 == 1, random);
    RegionGrower grower(rule);
    for (int i = 0; i < 3; ++i) {  // the grower is used again, and must have forgotten
      const CellIndex from = grid.index(static_cast<std::int32_t>(random.below(40)),
                                        static_cast<std::int32_t>(random.below(34)));
      if (!grid[from]) continue;
      expect_plain_growth(grid, from, rule, grower);
      ASSERT_FALSE(HasFailure()) << "seed " << seed;
    }
  }
}

// Walls, pillars and bends: rays of all slopes end at some, also at the map's border.
TEST(RegionGrower, EqualsThePlainAlgorithmInLargeClutteredMaps) {
  constexpr std::int32_t kWidth = 90, kHeight = 84;
  for (std::uint64_t seed = 0; seed < 25; ++seed) {
    Random random(seed);
    struct Box {
      std::int32_t left, bottom, right, top;
    };
    std::vector<Box> boxes;
    for (std::uint64_t i = random.below(14); i-- > 0;) {
      const auto left = static_cast<std::int32_t>(random.below(kWidth));
      const auto bottom = static_cast<std::int32_t>(random.below(kHeight));
      const auto long_side = static_cast<std::int32_t>(random.below(30));
      const auto short_side = static_cast<std::int32_t>(random.below(3));
      boxes.push_back(i % 2 == 0 ? Box{left, bottom, left + long_side, bottom + short_side}
                                 : Box{left, bottom, left + short_side, bottom + long_side});
    }
    const double share = seed % 4 == 0 ? 0.003 : 0;
    const auto grid = open_where(kWidth, kHeight, [&](int x, int y) {
      return random.uniform() >= share && std::none_of(boxes.begin(), boxes.end(), [&](auto& box) {
               return x >= box.left && x <= box.right && y >= box.bottom && y <= box.top;
             });
    });
    const GrowthRule rule = any_rule(60, seed % 5 == 4, random);
    RegionGrower grower(rule);
    for (int i = 0; i < 2; ++i) {
      const CellIndex from = grid.index(static_cast<std::int32_t>(random.below(kWidth)),
                                        static_cast<std::int32_t>(random.below(kHeight)));
      if (!grid[from]) continue;
      expect_plain_growth(grid, from, rule, grower);
      ASSERT_FALSE(HasFailure()) << "seed " << seed;
    }
  }
}

TEST(RegionGrower, InTheOpenIsADiscOfTheLargestRadius) {
  const auto grid = open_where(101, 101, [](int, int) { return true; });
  GrowthRule rule;
  rule.growth_radius = 6;
  rule.max_radius = 20;
  const Growth growth = RegionGrower(rule).grow(grid, grid.index(50, 50));
  EXPECT_EQ(count_cells(growth.runs), RingTable().cells_within(20));
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
  EXPECT_EQ(count_cells(growth.runs), RingTable().cells_within(7));
  rule.as_printed = false;
  EXPECT_LT(count_cells(RegionGrower(rule).grow(grid, grid.index(20, 20)).runs),
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
    const std::set<CellIndex> cells = cells_of(growth);
    return std::count_if(cells.begin(), cells.end(),
                         [&](CellIndex cell) { return grid.column(cell) > 31; });
  };
  EXPECT_LE(beyond(RegionGrower(rule).grow(grid, grid.index(14, 20))), 3);
  rule.obstacle_ratio = 0.5;
  EXPECT_GT(beyond(RegionGrower(rule).grow(grid, grid.index(14, 20))), 20);
}

}  // namespace
}  // namespace stope::topology
