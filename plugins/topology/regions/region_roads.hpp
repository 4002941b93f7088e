#pragma once

#include <vector>

#include "plugins/topology/regions/borders.hpp"
#include "plugins/topology/regions/region_memo.hpp"
#include "stope/payloads/road_graph.hpp"

namespace stope::topology {

/// Which of the roads between neighbouring regions are kept.
enum class Network { kAll, kSpanningTree, kSpanner };

struct RegionRoadsRule {
  double min_clearance = 0;  ///< metres; roads that get closer to an obstacle are left out
  double tolerance = 0.2;    ///< metres a simplified road may be off
  Network network = Network::kAll;
  double stretch = 1.5;  ///< of a spanner

  /// How far from the cells of its two regions a road depends on the map, in cells.
  std::int32_t reach(double resolution) const;
};

/// A road across each border, in their order: from centre to centre through the clearest place of
/// the border, within the two regions. Each half is straight if that keeps enough clearance, else
/// the way of least length over clearance. Regions are `known` up to their doors and ways, which
/// are found if they are not yet; `same` tells of which regions and all about them are as they were
/// when `before` was.
std::vector<RegionRoad> region_roads(const Ground& ground, const PaddedGrid<std::int32_t>& names,
                                     const RegionSet& set, const std::vector<Border>& borders,
                                     std::vector<RegionMemo::Known>& known,
                                     std::vector<std::uint8_t>& same, const RegionRoadsRule& rule,
                                     RegionMemo& before, const Checkpoint& checkpoint);

/// The graph with a node at each centre, and those of the roads that are wide enough and wanted.
RoadGraph graph_of_roads(const GridFrame& frame, const std::vector<RegionMemo::Known>& known,
                         const std::vector<Border>& borders, const std::vector<RegionRoad>& roads,
                         const RegionRoadsRule& rule);

}  // namespace stope::topology
