#pragma once

#include "plugins/topology/regions/region_roads.hpp"
#include "stope/payloads/region_map.hpp"

namespace stope::topology {

/// Regions and the roads between them. A region and its node in the graph have the same id.
struct RegionsAndRoads {
  RoadGraph roads;
  RegionMap map;
  std::size_t pieces = 0;                   ///< of the regions' adjacency
  std::size_t space_pieces = 0;             ///< of free space that have a region
  std::size_t neighbours = 0;               ///< pairs of regions that touch
  double covered = 0;                       ///< share of the free cells that are in a region
  std::vector<std::int32_t> label_of_name;  ///< what the cells of each name are to be labelled
  std::size_t dropped = 0;                  ///< parts of free space that were too small
  std::int64_t dropped_cells = 0;
};

/// Measures regions and connects them; the map's labels are left to write, for which the ground is
/// not needed any more. Parts of free space whose regions have less than `least_area` cells are
/// left out, but never the largest. `contacts` are those of all tiles. With a memo of the map
/// before, where only cells of `changed` squares differ, what is the same is taken from it, and it
/// becomes one of this map.
RegionsAndRoads finish_regions(const Ground& ground, const PaddedGrid<std::int32_t>& names,
                               const TileParts& tiles, const std::vector<Contact>& contacts,
                               RegionSet set, double least_area, const RegionRoadsRule& rule,
                               const Checkpoint& checkpoint, RegionMemo* memo = nullptr,
                               const ChangedSquares* changed = nullptr);

}  // namespace stope::topology
