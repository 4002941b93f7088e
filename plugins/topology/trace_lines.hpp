#pragma once

#include <vector>

#include "plugins/topology/dividing_lines.hpp"
#include "plugins/topology/line_network.hpp"

namespace stope::topology {

/// A link of two places of dividing lines by a way through free cells.
struct Link {
  CellIndex from = 0, to = 0;    ///< corners
  std::vector<CellIndex> cells;  ///< the way, neighbours by side or corner; not empty
};

/// The dividing lines as a network, with the obstacle each belongs to.
struct TracedLines {
  LineNetwork network;
  std::vector<CellIndex> corner;      ///< by node: where it is
  std::vector<std::int32_t> outline;  ///< by node: an outline of the free space it lies in
};

/// Follows the dividing lines from node to node: a node is a corner where they meet or end, or that
/// a link ends at. Each step of a line gives one point, accurate to a fraction of a cell: where two
/// cells see different obstacles, the place between their centres that is equally far from both.
/// Cost: linear in the lines' length.
TracedLines trace_lines(FreeSpace& space, const Outlines& outlines, const EdgeGrid& edges,
                        const std::vector<CellIndex>& corners, const std::vector<Link>& links);

}  // namespace stope::topology
