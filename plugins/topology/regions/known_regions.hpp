#pragma once

#include <cstdint>
#include <vector>

#include "plugins/topology/regions/region_roads.hpp"

namespace stope::topology {

/// What is known of the regions before their roads: from the memo, if all about a region is the
/// same, else measured; `same` tells which. `changed` are the squares with cells that differ from
/// the map of the memo, none if all of it may. Takes from `parts` and the memo what it needs.
std::vector<RegionMemo::Known> know_regions(
    const Ground& ground, const PaddedGrid<std::int32_t>& names, const RegionSet& set,
    RegionParts& parts, RegionMemo& memo, const ChangedSquares* changed,
    const RegionRoadsRule& rule, std::vector<std::uint8_t>& same, const Checkpoint& checkpoint);

/// Makes the memo one of these regions and the roads across these borders.
void remember_regions(std::vector<RegionMemo::Known> known, std::vector<RegionRoad> roads,
                      const std::vector<Border>& borders, RegionMemo& memo);

}  // namespace stope::topology
