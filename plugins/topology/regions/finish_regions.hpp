#pragma once

#include "plugins/topology/regions/region_roads.hpp"
#include "stope/payloads/region_map.hpp"

namespace stope::topology {

/// Regions and the roads between them. A region and its node in the graph have the same id.
struct RegionsAndRoads {
  RoadGraph roads;
  RegionMap map;
  std::size_t pieces = 0;      ///< of the regions' adjacency: parts of free space that do not touch
  std::size_t neighbours = 0;  ///< pairs of regions that touch
  double covered = 0;          ///< share of the free cells that are in a region
};

/// Measures the regions 1 … count: each one's centre is that of its convex hull or, if that is not
/// in the region or too near its walls, the nearest cell that has half the region's best clearance.
RegionsAndRoads finish_regions(const Ground& ground, const RegionCells& regions, std::int32_t count,
                               const RegionRoadsRule& rule, const Checkpoint& checkpoint);

}  // namespace stope::topology
