#pragma once

#include <string>
#include <vector>

#include "plugins/topology/regions/borders.hpp"
#include "plugins/topology/regions/region_shape.hpp"
#include "stope/payloads/road_graph.hpp"

namespace stope::topology {

/// Which of the roads between neighbouring regions are kept.
enum class Network { kAll, kSpanningTree, kSpanner };

struct RegionRoadsRule {
  double min_clearance = 0;  ///< metres; roads that get closer to an obstacle are left out
  double tolerance = 0.2;    ///< metres a simplified road may be off
  Network network = Network::kAll;
  double stretch = 1.5;  ///< of a spanner
};

/// A node at each centre (in the order of the regions, before the graph's canonical one), and a
/// road across each border: from centre to centre through the clearest place of the border, within
/// the two regions. Each half is straight if that keeps enough clearance, else the way of least
/// length over clearance.
RoadGraph region_roads(const Ground& ground, const RegionCells& regions,
                       const std::vector<ShapePoint>& centres, const std::vector<Border>& borders,
                       const RegionRoadsRule& rule, const Checkpoint& checkpoint);

}  // namespace stope::topology
