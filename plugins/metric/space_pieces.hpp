#pragma once

#include <cstddef>

#include "plugins/metric/free_cells.hpp"
#include "stope/payloads/road_graph.hpp"

namespace stope::metric {

/// Betti numbers: connected pieces, and independent cycles or holes.
struct Betti {
  std::size_t pieces = 0;
  std::size_t holes = 0;
};

/// Of free space: free cells 8-connected, obstacles 4-connected, everything outside of the grid one
/// obstacle. A hole's area is what its outer outline encloses; one of less than `min_hole_area`
/// square metres counts as free with all it encloses. A piece of free space of less than
/// `min_piece_area` is left out with all it encloses. O(cells).
Betti betti_of_space(const FreeCells& cells, double min_hole_area, double min_piece_area);

/// Of a graph: nodes without a road are pieces. holes = edges - nodes + pieces.
Betti betti_of_graph(const RoadGraph& graph);

}  // namespace stope::metric
