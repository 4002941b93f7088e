#pragma once

#include <cstdint>
#include <vector>

#include "plugins/topology/road_memo.hpp"

namespace stope::topology {

/// Measures a road between the ends of its vertices and gives it ids and a direction, as
/// canonicalize() does. A `ring` has one node.
FinishedRoad settle_road(std::vector<RoadVertex> vertices, double width, bool ring);

/// A settled road and the places of the two nodes it joins.
struct SettledRoad {
  std::int32_t from = 0, to = 0;
  const FinishedRoad* road = nullptr;
};

/// The graph of settled roads between these nodes: equal to what canonicalize() makes of the same.
/// Cost: n log n in nodes and roads, linear in vertices, all of which are only copied.
RoadGraph assemble_roads(const std::vector<RoadNode>& nodes, const std::vector<SettledRoad>& roads);

}  // namespace stope::topology
