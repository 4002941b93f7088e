#pragma once

#include "plugins/metric/free_cells.hpp"
#include "stope/payloads/road_graph.hpp"

namespace stope::metric {

/// The number of free cells whose centre lies in a disc round some point of the graph that reaches
/// to the nearest obstacle. Points are taken along the roads every 1/64 of their clearance, at
/// least a quarter of a cell; a disc between them can be larger than its neighbours by half of
/// that. Nodes without a road count as points.
std::size_t cells_in_discs(const RoadGraph& graph, const FreeCells& cells);

}  // namespace stope::metric
