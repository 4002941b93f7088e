#pragma once

#include <optional>
#include <vector>

#include "plugins/topology/regions/changed_tiles.hpp"
#include "plugins/topology/regions/growth_points.hpp"
#include "plugins/topology/regions/region_grower.hpp"

namespace stope::topology {

/// A region as it grew, and when: regions of earlier rounds grow first, then those of clearer
/// points.
struct GrownRegion {
  std::int32_t round = 0;
  GrowthPoint point;
  Growth growth;
};

/// What grew last time, and where the ground differs from then.
struct EarlierGrowth {
  std::vector<GrownRegion> regions;
  ChangedTiles changed;
  std::size_t reused = 0;  ///< is counted
};

/// Grows regions from the points, group after group, until every point is in one. Within a group
/// points with much room are first, so that regions lie side by side instead of in each other's
/// gaps. With `earlier`, regions are taken from it where nothing they read has changed; the result
/// is the same.
std::vector<GrownRegion> grow_regions(const Ground& ground,
                                      const std::vector<std::vector<GrowthPoint>>& groups,
                                      const GrowthRule& rule, const Checkpoint& checkpoint,
                                      EarlierGrowth* earlier = nullptr);

}  // namespace stope::topology
