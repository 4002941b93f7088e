#pragma once

#include "stope/payloads/road_graph.hpp"

namespace stope::exports {

/// Throws Error, naming the node or road, where a graph cannot be written as a route file: places
/// beyond its lists, roads of fewer than two vertices, places that are not finite, ids that two
/// share.
void check_writable(const RoadGraph& graph);

}  // namespace stope::exports
