#pragma once

#include <vector>

#include "plugins/topology/column_reach.hpp"
#include "plugins/topology/outlines.hpp"

namespace stope::topology {

/// Outlines that can change while millions of cells refer to their edges. An edge keeps its *name*
/// as long as it exists; its *number* tells where along the outlines it is.
struct NamedOutlines {
  Outlines by_name;                 ///< `list` is that of by_number
  Outlines by_number;               ///< what trace_outlines would give, but without `sides`
  std::vector<OutlineEdge> number;  ///< by name; -1: exists no more
  std::vector<OutlineEdge> name;    ///< by number; -1: no edge
  std::vector<std::uint8_t> side;   ///< by name

  NamedOutlines(const Outlines& outlines, const EdgeGrid& edges);
  std::vector<std::uint8_t> sides_by_number() const;
  /// Sets by_number.place, which updates leave empty.
  void place_by_number();
};

/// What a change of outlines means to cells that see edges of them.
struct OutlineChange {
  /// Names of the edges, new ones apart, that are within `reach` edges of a place where their
  /// outline is another than before.
  std::vector<OutlineEdge> near;
  /// Whether edges that were of one outline are of two now, or the other way round.
  bool regrouped = false;
};

/// Brings outlines up to date after cells of the window became obstacles or free: `space` has their
/// kObstacle bits as they are now, all else as it was. Sets kOnOutline, and in `edges` the places
/// of new outline cells. Names are only ever added. Cost: linear in the window and the length of
/// the outlines, but for those numbered before the first that changed.
OutlineChange update_outlines(NamedOutlines& outlines, FreeSpace& space, EdgeGrid& edges,
                              const CellWindow& window, std::int32_t reach);

}  // namespace stope::topology
