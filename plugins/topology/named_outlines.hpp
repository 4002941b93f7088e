#pragma once

#include <vector>

#include "plugins/topology/column_reach.hpp"
#include "plugins/topology/number_ranges.hpp"
#include "plugins/topology/outlines.hpp"

namespace stope::topology {

/// So many names from a multiple of it on were given at once: all at first, or after one change.
constexpr std::int32_t kNamesOfBlock = 32;

/// Outlines that can change while millions of cells refer to their edges. An edge keeps its *name*
/// as long as it exists; its *number* tells where along its outline it is. Outlines keep their
/// places in the lists and their edges' numbers while they do not change; a place whose outline is
/// gone has a count of 0.
struct NamedOutlines {
  Outlines by_name;
  Outlines by_number;               ///< without `sides`; outlines are in no particular order
  std::vector<OutlineEdge> number;  ///< by name; -1: exists no more
  std::vector<OutlineEdge> name;    ///< by number, where an outline has it
  std::vector<std::uint8_t> side;   ///< by name
  std::vector<std::uint8_t> side_by_number;
  std::vector<std::int32_t> unused;  ///< places in the lists
  std::vector<Outline> left;         ///< as they were numbered before the last change
  NumberRanges free_numbers;         ///< but for those of `left`

  NamedOutlines(const Outlines& outlines, const EdgeGrid& edges);
};

/// Edges that are in a row on an outline as they were before it changed, as many as there are.
struct StayedRun {
  std::int32_t outline = 0, first = 0, count = 0;  ///< from its first edge on
  /// Where they were: by its place then, which another outline may have now.
  std::int32_t old_outline = 0, old_first = 0, old_outline_count = 0;
  OutlineEdge old_outline_first = -1;  ///< its number then; -1: others may have had it since
};

/// How outlines have changed.
struct OutlineChange {
  /// Of those that have, the edges that stayed, in the order of `outlines` unless all have new
  /// numbers. Where a run ends, the outline is another.
  std::vector<StayedRun> runs;
  std::vector<std::int32_t> outlines;  ///< places of those with other numbers than before
};

/// Brings outlines up to date after cells of the window became obstacles or free: `space` has their
/// kObstacle bits as they are now, all else as it was. Sets kOnOutline, and in `edges` the places
/// of new outline cells. Names are only ever added. Cost: linear in the window and the length of
/// the outlines that reach into it; now and then in that of all.
OutlineChange update_outlines(NamedOutlines& outlines, FreeSpace& space, EdgeGrid& edges,
                              const CellWindow& window);

}  // namespace stope::topology
