#pragma once

#include "plugins/topology/outlines.hpp"

namespace stope::topology {

/// Finds for every free cell the outline edge of its nearest obstacle cell (Euclidean, exact, from
/// centre to centre), on the side that faces it. Obstacle cells of `edges` are left alone. Among
/// equally near obstacles a fixed one is taken.
void find_nearest_outline(const FreeSpace& space, const Outlines& outlines, EdgeGrid& edges,
                          const Checkpoint& checkpoint = never_stop);

/// Squared distance in cells from a free cell to the obstacle cell of an outline edge.
inline std::int64_t squared_distance(const EdgeGrid& edges, const Outlines& outlines,
                                     CellIndex cell, OutlineEdge edge) {
  const Outlines::Place place = outlines.place[static_cast<std::size_t>(edge)];
  const std::int64_t dx = edges.column(cell) - place.column;
  const std::int64_t dy = edges.row(cell) - place.row;
  return dx * dx + dy * dy;
}

}  // namespace stope::topology
