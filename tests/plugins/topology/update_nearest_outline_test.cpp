#include "plugins/topology/update_nearest_outline.hpp"

#include <gtest/gtest.h>

#include "plugins/topology/dividing_lines.hpp"
#include "tests/plugins/topology/test_grids.hpp"

namespace stope::topology {
namespace {

struct Map {
  explicit Map(const OccupancyGrid& grid)
      : space(make_free_space(grid, {})),
        edges(space.width(), space.height()),
        outlines(trace_outlines(space, edges, 0, 8)) {
    find_nearest_outline(space, outlines, edges);
  }
  bool is_free(CellIndex cell) const { return !(space[cell] & kObstacle); }
  /// What a cell sees, whatever numbers the outlines' edges have.
  std::tuple<std::int32_t, std::int32_t, std::int64_t> seen_from(CellIndex cell) const {
    const OutlineEdge edge = edges[cell];
    const Outlines::Place place = outlines.place[static_cast<std::size_t>(edge)];
    const auto& sides =
        outlines.sides[static_cast<std::size_t>(edges[edges.index(place.column, place.row)])];
    return {place.column, place.row, std::find(sides.begin(), sides.end(), edge) - sides.begin()};
  }
  FreeSpace space;
  EdgeGrid edges;
  Outlines outlines;
};

/// Some cells within the window get another value: all free, all obstacles, or by chance.
OccupancyGrid changed_within(OccupancyGrid grid, const CellWindow& window, Random& random) {
  const double free = random.uniform() < 0.3 ? 0 : random.uniform() < 0.5 ? 1 : random.uniform();
  for (std::int32_t row = window.row; row < window.row + window.height; ++row)
    for (std::int32_t column = window.column; column < window.column + window.width; ++column)
      grid.cells[grid.frame.place({column, row})] =
          random.uniform() < free ? OccupancyGrid::kFree : OccupancyGrid::kOccupied;
  return grid;
}

std::int32_t below(Random& random, std::int32_t count) {
  return static_cast<std::int32_t>(random.uniform() * count);
}

CellWindow window_in(const OccupancyGrid& grid, Random& random) {
  CellWindow window{below(random, grid.frame.width), below(random, grid.frame.height), 1, 1};
  window.width += below(random, std::min(12, grid.frame.width - window.column));
  window.height += below(random, std::min(12, grid.frame.height - window.row));
  return window;
}

bool has_free_cell(const OccupancyGrid& grid) {
  return std::count(grid.cells.begin(), grid.cells.end(), OccupancyGrid::kFree) > 0;
}

/// Brings the transform of one grid to that of another and compares it with the full one.
/// Returns how many cells were found stale and how many of them free cells that see another cell.
std::pair<std::size_t, std::size_t> expect_update(const OccupancyGrid& before,
                                                  const OccupancyGrid& after,
                                                  const CellWindow& window) {
  const Map old(before);
  Map now(after);
  ColumnReach reach(old.space);
  const auto changed = reach.update(now.space, window);
  const auto spans = find_stale_spans(window, changed, old.edges, old.outlines, now.space);

  const ColumnReach whole(now.space);
  std::vector<bool> stale(now.space.size());
  std::size_t count = 0;
  for (const StaleSpan& span : spans) {
    count += static_cast<std::size_t>(span.cells.end - span.cells.begin);
    for (std::int32_t column = span.cells.begin; column < span.cells.end; ++column)
      stale[static_cast<std::size_t>(now.space.index(column, span.cells.row))] = true;
  }
  EdgeGrid edges(now.space.width(), now.space.height());
  std::copy_n(now.edges.data(), now.edges.size(), edges.data());
  for (std::int32_t row = 0; row < now.space.height(); ++row) {
    for (std::int32_t column = 0; column < now.space.width(); ++column) {
      const CellIndex cell = now.space.index(column, row);
      EXPECT_EQ(reach.nearest_row(cell, row), whole.nearest_row(cell, row));
      if (!now.is_free(cell)) continue;
      if (stale[static_cast<std::size_t>(cell)]) {
        edges[cell] = -7;  // must be found anew, and must not be read
      } else {
        EXPECT_TRUE(old.is_free(cell));
        EXPECT_EQ(old.seen_from(cell), now.seen_from(cell)) << column << ", " << row;
      }
    }
  }
  update_nearest_outline(spans, reach, now.space, now.outlines, edges);
  EXPECT_TRUE(std::equal(edges.data(), edges.data() + edges.size(), now.edges.data()));
  std::size_t different = 0;
  for (const StaleSpan& span : spans) {
    for (std::int32_t column = span.cells.begin; column < span.cells.end; ++column) {
      const CellIndex cell = now.space.index(column, span.cells.row);
      different +=
          now.is_free(cell) && !(old.is_free(cell) && old.seen_from(cell) == now.seen_from(cell));
    }
  }
  return {count, different};
}

void expect_updates(std::int32_t width, std::int32_t height, double free, std::int32_t block,
                    std::uint64_t seeds) {
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    Random random(mix_seed(seed, static_cast<std::uint64_t>(width * 1000 + block)));
    OccupancyGrid grid = random_grid(width, height, free, block, seed);
    for (int change = 0; change < 4; ++change) {
      const CellWindow window = window_in(grid, random);
      OccupancyGrid next = changed_within(grid, window, random);
      if (!has_free_cell(grid) || !has_free_cell(next)) break;
      expect_update(grid, next, window);
      grid = std::move(next);
      if (testing::Test::HasFailure()) return;
    }
  }
}

TEST(UpdateNearestOutline, EqualsTheFullTransformAfterRandomChanges) {
  expect_updates(47, 39, 0.5, 1, 40);
  expect_updates(47, 39, 0.98, 1, 80);
  expect_updates(61, 53, 0.6, 6, 80);
  expect_updates(53, 61, 1.0, 1, 40);
}

TEST(UpdateNearestOutline, EqualsTheFullTransformInOneRowOrColumn) {
  expect_updates(40, 1, 0.8, 1, 40);
  expect_updates(1, 40, 0.8, 1, 40);
  expect_updates(2, 2, 0.7, 1, 40);
}

TEST(UpdateNearestOutline, FindsNothingStaleWhereNothingChanged) {
  const OccupancyGrid grid = random_grid(40, 30, 0.7, 3, 5);
  EXPECT_EQ(expect_update(grid, grid, {3, 4, 20, 10}).first, 0U);
}

TEST(UpdateNearestOutline, WorksOnLittleMoreThanWhatChanges) {
  const OccupancyGrid yard = random_grid(201, 201, 1.0, 1, 1);
  OccupancyGrid with_truck = yard;
  with_truck.cells[yard.frame.place({100, 10})] = OccupancyGrid::kOccupied;
  for (const auto& [stale, different] : {expect_update(yard, with_truck, {100, 10, 1, 1}),
                                         expect_update(with_truck, yard, {100, 10, 1, 1})})
    EXPECT_LT(stale, different + different / 4);
}

TEST(DividingLines, TellWhichEdgesTheyReplaced) {
  std::size_t count = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Map map(random_grid(60, 60, 0.8, 1, seed));
    const std::vector<OutlineEdge> nearest(map.edges.data(), map.edges.data() + map.edges.size());
    std::vector<ReplacedEdge> replaced;
    find_dividing_lines(map.space, map.outlines, SideRule::between_outlines(map.outlines),
                        map.edges, never_stop, &replaced);
    count += replaced.size();
    for (const ReplacedEdge& edge : replaced) map.edges[edge.cell] = edge.nearest;
    EXPECT_TRUE(std::equal(nearest.begin(), nearest.end(), map.edges.data()));
  }
  EXPECT_GT(count, 0U);
}

}  // namespace
}  // namespace stope::topology
