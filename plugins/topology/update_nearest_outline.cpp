// Problem: some obstacles have changed; bring the distance transform up to date without computing
// all of it.
// Idea: the nearest obstacle cell of a cell lies in some column, and only columns whose reach has
// changed can gain or lose cells. A cell whose nearest obstacle was or will be in such a column is
// at least as far from an obstacle as from the column, so these cells are in a stretch around the
// columns, found by walking outwards. Along a row the columns of nearest obstacles never decrease,
// so the neighbours of the stretch, which keep theirs, tell which columns can matter within it.
// Cost: linear in the cells of the stretches.
#include "plugins/topology/update_nearest_outline.hpp"

#include "plugins/topology/nearest_outline.hpp"
#include "plugins/topology/row_envelope.hpp"
#include "plugins/topology/write_edges.hpp"

namespace stope::topology {
namespace {

bool is_obstacle(const FreeSpace& space, CellIndex cell) { return space[cell] & kObstacle; }

}  // namespace

std::vector<StaleSpan> find_stale_spans(const CellWindow& window,
                                        const std::vector<RowSpan>& changed_reach,
                                        const EdgeGrid& edges, const Outlines& outlines,
                                        const FreeSpace& space) {
  std::vector<StaleSpan> spans;
  spans.reserve(changed_reach.size());
  for (const RowSpan& changed : changed_reach) {
    const std::int64_t rows = std::max<std::int64_t>(
        {0, window.row - changed.row, changed.row - (window.row + window.height - 1)});
    // Whether an obstacle is nearer than `columns` columns and `rows` rows away.
    const auto keeps = [&](std::int32_t column, std::int64_t columns, std::int64_t rows) {
      const CellIndex cell = space.index(column, changed.row);
      return is_obstacle(space, cell) ||
             squared_distance(edges, outlines, cell, edges[cell]) < columns * columns + rows * rows;
    };
    const auto nearest_column = [&](std::int32_t column) {
      const CellIndex cell = space.index(column, changed.row);
      if (is_obstacle(space, cell)) return column;
      return outlines.place[static_cast<std::size_t>(edges[cell])].column;
    };
    std::int32_t begin = changed.begin, end = changed.end;
    while (!keeps(begin - 1, changed.begin - (begin - 1), 0)) --begin;
    while (!keeps(end, end - (changed.end - 1), 0)) ++end;
    // Beyond them nothing changes; seen from further up or down, nor does all before them.
    while (begin < changed.begin && keeps(begin, changed.begin - begin, rows)) ++begin;
    while (end > changed.end && keeps(end - 1, end - changed.end, rows)) --end;
    spans.push_back({{changed.row, begin, end}, nearest_column(begin - 1), nearest_column(end)});
  }
  return spans;
}

void update_nearest_outline(const std::vector<StaleSpan>& spans, const ColumnReach& reach,
                            const FreeSpace& space, const Outlines& outlines, EdgeGrid& edges) {
  auto memory = RowEnvelope::memory_for(space.stride());
  for (const StaleSpan& span : spans) {
    const std::int32_t row = span.cells.row;
    const auto is_free = [&](std::int32_t column) {
      return !is_obstacle(space, space.index(column, row));
    };
    for (std::int32_t begin = span.cells.begin; begin < span.cells.end;) {
      if (!is_free(begin)) {
        ++begin;
        continue;
      }
      std::int32_t end = begin + 1;
      while (end < span.cells.end && is_free(end)) ++end;
      // An obstacle beside the run hides all beyond it.
      const std::int32_t first = is_free(begin - 1) ? span.first_column : begin - 1;
      const std::int32_t last = is_free(end) ? span.last_column : end;
      RowEnvelope envelope(memory, row, first, reach.nearest_row(space.index(first, row), row));
      for (std::int32_t column = first + 1; column <= last; ++column)
        envelope.add(column, reach.nearest_row(space.index(column, row), row));
      envelope.for_each_piece(begin, end, [&](auto from, auto to, auto column, auto site_row) {
        write_edges(outlines, edges, row, begin, from, to, column, site_row);
      });
      begin = end;
    }
  }
}

}  // namespace stope::topology
