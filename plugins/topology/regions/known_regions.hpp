#pragma once

#include <vector>

#include "plugins/topology/regions/region_memo.hpp"
#include "plugins/topology/regions/region_roads.hpp"

namespace stope::topology {

/// What is known of the regions before their roads: from the memo, if all about a region is the
/// same, else measured; `same` tells which. `changed` are the squares with cells that differ from
/// the map of the memo, none if all of it may. Takes from `parts` and the memo what it needs.
std::vector<KnownRegion> know_regions(const Ground& ground, const PaddedGrid<std::int32_t>& names,
                                      const TileParts& tiles, const RegionSet& set,
                                      RegionParts& parts, RegionMemo& memo,
                                      const ChangedSquares* changed, const RegionRoadsRule& rule,
                                      SameRegions& same, const Checkpoint& checkpoint);

/// Makes the memo one of these regions and the roads through these doors.
void remember_regions(std::vector<KnownRegion> known, const std::vector<Door>& doors,
                      std::vector<RegionRoad> roads, RegionMemo& memo);

}  // namespace stope::topology
