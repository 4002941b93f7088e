#pragma once

#include <vector>

#include "plugins/topology/column_reach.hpp"
#include "plugins/topology/outlines.hpp"

namespace stope::topology {

/// Cells of a row whose nearest obstacle may be another after a change.
struct StaleSpan {
  RowSpan cells;
  /// Columns of the obstacle cells nearest to the cells just before and after the span; those of
  /// the span lie between.
  std::int32_t first_column = 0, last_column = 0;
};

/// Which cells may have another nearest obstacle cell, at most one span a row, from the lowest row
/// up; all others keep it. Obstacles have changed within `window`; `space` has them as they are now
/// and `changed_reach` is what ColumnReach::update returned for it; `edges` and `outlines` are
/// still those find_nearest_outline gave before the change (find_dividing_lines alters some: undo
/// that). Cost: linear in the cells of the spans.
std::vector<StaleSpan> find_stale_spans(const CellWindow& window,
                                        const std::vector<RowSpan>& changed_reach,
                                        const EdgeGrid& edges, const Outlines& outlines,
                                        const FreeSpace& space);

/// Finds the nearest outline edge of the free cells of the spans, with the result that
/// find_nearest_outline has. `outlines` and the obstacle cells of `edges` are those of now; free
/// cells of `edges` are not read. Cost: linear in the cells of the spans and those between their
/// first and last columns.
void update_nearest_outline(const std::vector<StaleSpan>& spans, const ColumnReach& reach,
                            const FreeSpace& space, const Outlines& outlines, EdgeGrid& edges);

}  // namespace stope::topology
