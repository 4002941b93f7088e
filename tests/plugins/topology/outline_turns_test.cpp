#include "plugins/topology/outline_turns.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/plugins/topology/outline_grids.hpp"

namespace stope::topology {
namespace {

/// The share of an outline's edges that turn.
double turning_share(const OccupancyGrid& grid, const TurnRule& rule) {
  const Outlines outlines = outlines_of(grid);
  return static_cast<double>(find_turns(outlines, rule).whole.at(0)) / outlines.list[0].count;
}

TEST(OutlineTurns, AYardTurnsAllRoundIfItIsNarrowerThanTheRuleAsks) {
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

TEST(OutlineTurns, CornersTurnWhateverTheirDirectionAndStraightWallsDoNot) {
  for (const double degrees : {0.0, 11.0, 26.565, 45.0, 71.0}) {
    // Four corners with 20 m around each, of 200 m (staircases are up to 1.41 times as long).
    const double share = turning_share(turned_strip(degrees), {1.0, 20});
    EXPECT_GT(share, 0.02) << degrees;
    EXPECT_LT(share, 0.4) << degrees;
    EXPECT_EQ(turning_share(turned_strip(degrees), {2.2, 40}), 0) << degrees;
  }
}

TEST(OutlineTurns, AnObstacleInTheOpenDoesNotTurnTowardsFreeSpace) {
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
TEST(OutlineTurns, TurnsDoNotDependOnWhereAnOutlineStarts) {
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

/// A winding wall, so that windows cut long outlines, join and part them.
OccupancyGrid winding_grid(std::int32_t side, std::uint64_t seed) {
  return grid_where(side, side, 1.0, [=](double x, double y) {
    return roughness(x, y, 1.0 / 40, seed) + 0.4 * roughness(x, y, 1.0 / 9, seed + 1) > -0.1;
  });
}

// Turns are only looked for beside what changed; all others are those of before.
TEST(OutlineTurns, AreThoseOfAWholeSearchAfterEveryChange) {
  const TurnRule rule{1.0, 40};
  const std::int32_t side = 260;
  const OccupancyGrid grid = winding_grid(side, 3);
  FreeSpace space = make_free_space(grid, {});
  EdgeGrid edges(side, side);
  NamedOutlines outlines(trace_outlines(space, edges, 0, 4), edges);
  OutlineTurns turns;
  const auto find_all = [&](OutlineTurns& found) {
    for (std::size_t i = 0; i < outlines.by_number.list.size(); ++i)
      if (outlines.by_number.list[i].count > 0)
        find_turns(outlines.by_number, outlines.side_by_number, static_cast<std::int32_t>(i), {},
                   rule, found);
  };
  find_all(turns);
  Random random(5);
  std::int32_t kept = 0;
  for (int change = 0; change < 120; ++change) {
    const CellWindow window{static_cast<std::int32_t>(random.uniform(1.0, side - 14)),
                            static_cast<std::int32_t>(random.uniform(1.0, side - 14)), 12, 12};
    const double share = change % 3 == 0 ? 0.0 : change % 3 == 1 ? 1.0 : 0.4;
    for (std::int32_t row = window.row; row < window.row + window.height; ++row)
      for (std::int32_t column = window.column; column < window.column + window.width; ++column) {
        std::uint8_t& cell = space[space.index(column, row)];
        const bool obstacle = random.uniform() < share;
        cell = static_cast<std::uint8_t>(obstacle ? cell | kObstacle : cell & ~kObstacle);
      }
    const OutlineChange changed = update_outlines(outlines, space, edges, window);
    for (const std::int32_t place : changed.outlines) {
      std::vector<StayedRun> runs;
      for (const StayedRun& run : changed.runs)
        if (run.outline == place) runs.push_back(run);
      for (const StayedRun& run : runs) kept += run.count > 2 * reach_of_turns(rule) ? 1 : 0;
      find_turns(outlines.by_number, outlines.side_by_number, place, runs, rule, turns);
    }
    OutlineTurns all;
    find_all(all);
    for (std::size_t i = 0; i < outlines.by_number.list.size(); ++i) {
      const Outline& outline = outlines.by_number.list[i];
      if (outline.count == 0) continue;
      ASSERT_EQ(turns.whole[i], all.whole[i]) << change;
      for (OutlineEdge edge = outline.first; edge < outline.first + outline.count; ++edge) {
        ASSERT_EQ(turns.turning[static_cast<std::size_t>(edge)],
                  all.turning[static_cast<std::size_t>(edge)])
            << change;
        ASSERT_EQ(turns.before[static_cast<std::size_t>(edge)],
                  all.before[static_cast<std::size_t>(edge)])
            << change;
      }
    }
  }
  EXPECT_GT(kept, 50);
}

}  // namespace
}  // namespace stope::topology
