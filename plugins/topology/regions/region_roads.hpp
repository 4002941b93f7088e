#pragma once

#include <vector>

#include "plugins/topology/regions/borders.hpp"
#include "plugins/topology/regions/region_memo.hpp"
#include "stope/payloads/road_graph.hpp"

namespace stope::topology {

/// Which of the roads between neighbouring regions are kept.
enum class Network { kAll, kSpanningTree, kSpanner };

struct RegionRoadsRule {
  double min_clearance = 0;  ///< metres; roads keep at least as far from obstacles
  double tolerance = 0.2;    ///< metres a simplified road may be off
  Network network = Network::kAll;
  double stretch = 1.5;       ///< of a spanner
  double centre_share = 0.5;  ///< of a region's best clearance that its centre has at least
  bool every_door = false;    ///< a road through each door of two regions, not the clearest only

  /// How far from the cells of its two regions a road depends on the map, in cells.
  std::int32_t reach(double resolution) const;
  /// Least distance of a road from the centre of an obstacle cell, in cells, and the least square
  /// of one that a cell must have; at least 1.
  double least_distance(double resolution) const;
  std::int32_t least_squared(double resolution) const;
};

/// A road through each door, in their order: from centre to centre through its clearest place,
/// within the two regions. Each half is straight if that keeps enough clearance, else the way of
/// least length over clearance. Without a line if there is no way that keeps to min_clearance.
/// Regions are `known` up to their doors and ways, which are found where they are not known from
/// the map before. What the memo knows of doors that are there again is taken from it.
std::vector<RegionRoad> region_roads(const Ground& ground, const PaddedGrid<std::int32_t>& names,
                                     const TileParts& tiles, const RegionSet& set,
                                     const RegionParts& parts, const std::vector<Door>& doors,
                                     std::vector<KnownRegion>& known, const RegionRoadsRule& rule,
                                     RegionMemo& memo, const Checkpoint& checkpoint);

/// The graph with a node at each centre, and those of the roads that are wide enough and wanted.
RoadGraph graph_of_roads(const GridFrame& frame, const std::vector<KnownRegion>& known,
                         const std::vector<Door>& doors, const std::vector<RegionRoad>& roads,
                         const RegionRoadsRule& rule);

}  // namespace stope::topology
