#pragma once

#include <vector>

#include "plugins/topology/line_network.hpp"
#include "plugins/topology/road_memo.hpp"

namespace stope::topology {

/// Measures a road between the ends of its vertices and gives it ids and a direction, as
/// canonicalize() does. A `ring` has one node.
FinishedRoad settle_road(std::vector<RoadVertex> vertices, double width, bool ring);

/// The graph of settled roads, in the order of the network's lines, with `nodes` in the order of
/// the network's nodes: equal to what canonicalize() makes of the same. Cost: n log n in nodes and
/// roads, linear in vertices, all of which are only copied.
RoadGraph assemble_roads(const LineNetwork& network, const std::vector<RoadNode>& nodes,
                         const std::vector<const FinishedRoad*>& roads);

}  // namespace stope::topology
