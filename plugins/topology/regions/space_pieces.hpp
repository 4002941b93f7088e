#pragma once

#include <cstddef>

#include "plugins/topology/regions/region_set.hpp"

namespace stope::topology {

/// How many pieces of free space, 8-connected, have a cell with a region.
std::size_t count_space_pieces(const Ground& ground, const PaddedGrid<std::int32_t>& names,
                               const RegionSet& set, const Checkpoint& checkpoint);

}  // namespace stope::topology
