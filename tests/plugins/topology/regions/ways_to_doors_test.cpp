#include "plugins/topology/regions/ways_to_doors.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <queue>

#include "tests/plugins/topology/everything.hpp"
#include "tests/plugins/topology/test_grids.hpp"

namespace stope::topology {
namespace {

constexpr std::int32_t kWidth = 120, kHeight = 90;

/// Free space of which two thirds are in region 1, on both sides of another, which leaves a way
/// between them or not.
struct TwoSides {
  explicit TwoSides(std::uint64_t seed)
      : ground(random_grid(kWidth, kHeight, 0.85, 6, seed), everything()),
        names(without_regions(ground)),
        tiles(kWidth, kHeight) {
    for (std::int32_t row = 0; row < kHeight; ++row)
      for (std::int32_t column = 0; column < kWidth; ++column)
        if (const CellIndex cell = ground.index(column, row); ground.free(cell))
          names[cell] = column / 40 == 1 && (row < 45 || seed % 4 == 0) ? 2 : 1;
    set.of_name = {0, 1, 0};
    set.key_of_name = {0, 0, 0};
    set.count = 1;
    tiles.look_at(ground, names, all_tiles(ground), never_stop);
  }
  bool is_way(CellIndex cell, std::int32_t least) const {
    return names[cell] == 1 && ground.squared(cell) >= least;
  }
  double slowness(CellIndex cell) const {
    return 1 / (std::sqrt(static_cast<double>(ground.squared(cell))) - 0.5);
  }
  double step_cost(CellIndex from, CellIndex to) const {
    const bool diagonal =
        ground.row(from) != ground.row(to) && ground.column(from) != ground.column(to);
    return (diagonal ? std::sqrt(2.0) : 1.0) * (slowness(from) + slowness(to)) / 2;
  }
  double cost(const std::vector<CellIndex>& way) const {
    double sum = 0;
    for (std::size_t i = 1; i < way.size(); ++i) sum += step_cost(way[i - 1], way[i]);
    return sum;
  }
  /// By Dijkstra's algorithm: what the way from `centre` to each cell costs.
  std::vector<double> costs_from(CellIndex centre, std::int32_t least) const {
    std::vector<double> costs(ground.size(), std::numeric_limits<double>::infinity());
    using Entry = std::pair<double, CellIndex>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    costs[static_cast<std::size_t>(centre)] = 0;
    open.push({0, centre});
    while (!open.empty()) {
      const auto [sum, cell] = open.top();
      open.pop();
      if (sum > costs[static_cast<std::size_t>(cell)]) continue;
      for (const CellIndex step : neighbour_steps(ground.stride())) {
        const CellIndex next = cell + step;
        if (!is_way(next, least)) continue;
        double& known = costs[static_cast<std::size_t>(next)];
        if (sum + step_cost(cell, next) >= known) continue;
        known = sum + step_cost(cell, next);
        open.push({known, next});
      }
    }
    return costs;
  }

  Ground ground;
  PaddedGrid<std::int32_t> names;
  TileParts tiles;
  RegionSet set;
};

bool is_straight(const TwoSides& map, const std::vector<CellIndex>& way) {
  const auto steps =
      std::max(std::abs(map.ground.column(way.front()) - map.ground.column(way.back())),
               std::abs(map.ground.row(way.front()) - map.ground.row(way.back())));
  return way.size() == static_cast<std::size_t>(steps) + 1;
}

TEST(WaysToDoors, AreAsGoodAsWaysCanBeAndDoNotDependOnOtherDoors) {
  std::size_t searched = 0, missing = 0;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const TwoSides map(seed);
    Random random(seed);
    const auto least = static_cast<std::int32_t>(1 + 3 * (seed % 3));
    std::vector<CellIndex> cells;
    for (std::size_t i = 0; i < map.ground.size(); ++i)
      if (map.is_way(static_cast<CellIndex>(i), least)) cells.push_back(static_cast<CellIndex>(i));
    std::int32_t widest = 0;
    for (const CellIndex cell : cells) widest = std::max(widest, map.ground.squared(cell));
    const auto draw = [&] { return cells[random.below(cells.size())]; };
    const CellIndex centre = draw();
    const std::vector<CellIndex> doors{draw(), draw(), draw(), draw(), draw()};
    const auto tiles = [&] {
      const auto own = map.tiles.tiles_of(1);
      return std::vector<std::int32_t>(own.begin(), own.end());
    };
    WaysToDoors finder(map.ground, map.names, map.set, least);
    const bool many = seed % 2 == 1;
    const auto ways = finder.find(centre, doors, many, widest, tiles);
    const std::vector<double> costs = map.costs_from(centre, least);
    ASSERT_EQ(ways.size(), doors.size());
    for (std::size_t i = 0; i < doors.size(); ++i) {
      const double best = costs[static_cast<std::size_t>(doors[i])];
      EXPECT_EQ(finder.find(centre, {doors[i]}, many, widest, tiles).front(), ways[i]);
      if (std::isinf(best)) {
        EXPECT_TRUE(ways[i].empty());
        ++missing;
        continue;
      }
      ASSERT_FALSE(ways[i].empty()) << "seed " << seed << ", door " << i;
      EXPECT_EQ(ways[i].front(), doors[i]);
      EXPECT_EQ(ways[i].back(), centre);
      if (is_straight(map, ways[i])) continue;
      EXPECT_NEAR(map.cost(ways[i]), best, 1e-4 * best) << "seed " << seed << ", door " << i;
      ++searched;
    }
  }
  EXPECT_GT(searched, 60U);
  EXPECT_GT(missing, 0U);
}

}  // namespace
}  // namespace stope::topology
