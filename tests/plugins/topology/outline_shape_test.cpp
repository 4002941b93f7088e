#include "plugins/topology/outline_shape.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/plugins/topology/test_grids.hpp"

namespace stope::topology {
namespace {

Outlines outlines_of(const OccupancyGrid& grid, FreeSpace* kept = nullptr) {
  FreeSpace space = make_free_space(grid, {});
  EdgeGrid edges(space.width(), space.height());
  Outlines outlines = trace_outlines(space, edges, 0, 4);
  if (kept) *kept = std::move(space);
  return outlines;
}

/// Free within a half plane's strip of 80 x 20 m, turned; its outline is 200 m long.
OccupancyGrid turned_strip(double degrees) {
  const double c = std::cos(degrees * std::numbers::pi / 180),
               s = std::sin(degrees * std::numbers::pi / 180);
  return grid_where(100, 100, 0.5, [=](double x, double y) {
    const double u = c * (x - 50) + s * (y - 50), v = -s * (x - 50) + c * (y - 50);
    return std::abs(u) < 40 && std::abs(v) < 10;
  });
}

TEST(OutlineShape, WaysAreAsLongAsTheWallsWhateverTheirDirection) {
  for (const double degrees : {0.0, 3.0, 11.0, 26.565, 30.0, 45.0, 71.0, 90.0}) {
    const OutlineWays ways = measure_ways(outlines_of(turned_strip(degrees)));
    ASSERT_EQ(ways.whole.size(), 1U);
    EXPECT_NEAR(static_cast<double>(ways.whole[0]) / OutlineWays::kUnit * 0.5, 200, 8) << degrees;
  }
  const OutlineWays circle = measure_ways(outlines_of(grid_where(
      100, 100, 0.5, [](double x, double y) { return std::hypot(x - 50, y - 50) < 40; })));
  EXPECT_NEAR(static_cast<double>(circle.whole.at(0)) / OutlineWays::kUnit * 0.5,
              2 * std::numbers::pi * 40, 5);
}

TEST(OutlineShape, TheWayBetweenTwoEdgesIsTheShorterOne) {
  const Outlines outlines = outlines_of(turned_strip(20));
  const OutlineWays ways = measure_ways(outlines);
  const Outline& outline = outlines.list.at(0);
  const double whole = static_cast<double>(ways.whole[0]) / OutlineWays::kUnit;
  for (std::int32_t i = 0; i < outline.count; i += 7) {
    for (std::int32_t k = 0; k < outline.count; k += 11) {
      const double way = ways.between(outline.first + i, outline.first + k, 0);
      EXPECT_LE(way, whole / 2 + 1e-9);
      EXPECT_EQ(way, ways.between(outline.first + k, outline.first + i, 0));
    }
  }
}

/// The share of an outline's edges that turn.
double turning_share(const OccupancyGrid& grid, const TurnRule& rule) {
  const Outlines outlines = outlines_of(grid);
  return static_cast<double>(find_turns(outlines, rule).whole.at(0)) / outlines.list[0].count;
}

TEST(OutlineShape, AYardTurnsAllRoundIfItIsNarrowerThanTheRuleAsks) {
  // A circle of radius R turns by length / R: here the length is 40 m in cells of half a metre. Its
  // staircase is 4 / pi times as long as the circle.
  const TurnRule rule{1.0, 80 * 4 / std::numbers::pi};
  const auto yard = [](double radius) {
    return grid_where(140, 140, 0.5,
                      [=](double x, double y) { return std::hypot(x - 70, y - 70) < radius; });
  };
  EXPECT_GT(turning_share(yard(30), rule), 0.98);
  EXPECT_LT(turning_share(yard(60), rule), 0.05);
}

TEST(OutlineShape, CornersTurnWhateverTheirDirectionAndStraightWallsDoNot) {
  for (const double degrees : {0.0, 11.0, 26.565, 45.0, 71.0}) {
    // Four corners with 20 m around each, of 200 m (staircases are up to 1.41 times as long).
    const double share = turning_share(turned_strip(degrees), {1.0, 20});
    EXPECT_GT(share, 0.02) << degrees;
    EXPECT_LT(share, 0.4) << degrees;
    EXPECT_EQ(turning_share(turned_strip(degrees), {2.2, 40}), 0) << degrees;
  }
}

TEST(OutlineShape, AnObstacleInTheOpenDoesNotTurnTowardsFreeSpace) {
  const OccupancyGrid grid = grid_where(80, 80, 0.5, [](double x, double y) {
    return std::abs(x - 40) > 10 || std::abs(y - 40) > 10;
  });
  const Outlines outlines = outlines_of(grid);
  const OutlineTurns turns = find_turns(outlines, {1.0, 40});
  for (std::size_t i = 0; i < outlines.list.size(); ++i) {
    const bool block = outlines.list[i].left > 10;
    if (block) {
      EXPECT_EQ(turns.whole[i], 0);
    } else {
      EXPECT_GT(turns.whole[i], 0);
    }
  }
}

// What follows from an outline must not depend on which of its cells comes first: mirrored and
// turned maps start elsewhere.
TEST(OutlineShape, TurnsDoNotDependOnWhereAnOutlineStarts) {
  const OccupancyGrid grid = random_grid(60, 60, 0.75, 5, 3);
  OccupancyGrid turned = grid;
  for (std::int32_t row = 0; row < 60; ++row)
    for (std::int32_t column = 0; column < 60; ++column)
      turned.cells[turned.frame.place({59 - column, 59 - row})] =
          grid.cells[grid.frame.place({column, row})];
  const auto sum = [](const OccupancyGrid& map) {
    std::vector<std::int32_t> wholes = find_turns(outlines_of(map), {1.0, 24}).whole;
    std::sort(wholes.begin(), wholes.end());
    return wholes;
  };
  EXPECT_EQ(sum(grid), sum(turned));
}

}  // namespace
}  // namespace stope::topology
