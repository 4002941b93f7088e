#pragma once

#include "stope/payloads/elevation_grid.hpp"
#include "stope/payloads/road_graph.hpp"

namespace stope::topology {

/// Sets the height of every node and vertex from a ground grid, whose frame may be another than the
/// map's, and measures the graph anew (grade). Polylines get vertices where the ground between two
/// bends, so that a profile drawn through their heights is within `tolerance` metres of the grid's,
/// looked at every metre. Heights are bilinear between cell centres, constant over the outer half
/// of border cells, and NaN outside of the grid and beside cells that are not known. Throws Error
/// if the grid's numbers contradict each other.
void give_elevation(RoadGraph& roads, const ElevationGrid& elevation, double tolerance = 0.1);

}  // namespace stope::topology
