#pragma once

#include <cstdint>
#include <vector>

#include "plugins/topology/regions/region_roads.hpp"
#include "plugins/topology/regions/region_shape.hpp"

namespace stope::topology {

struct RegionCentre {
  ShapePoint place;
  std::int32_t widest = 0;  ///< the region's best squared clearance, but for what is cut off
};

/// Where a region's node stands: at the centre of gravity of its convex hull or, if that is not in
/// the region or too near its walls, the nearest cell that has enough of the region's best
/// clearance. `own_tiles` are all with cells of the region.
RegionCentre centre_of_region(const Ground& ground, const PaddedGrid<std::int32_t>& names,
                              const TileParts& tiles, const RegionSet& set, std::int32_t region,
                              const std::vector<std::int32_t>& own_tiles, const RegionShape& shape,
                              const RegionRoadsRule& rule);

}  // namespace stope::topology
