#pragma once

#include <cstddef>

#include "plugins/topology/regions/region_set.hpp"

namespace stope::topology {

/// How many pieces of free space, 8-connected, have a cell with a region. `tiles` and `contacts`
/// are of these names.
std::size_t count_space_pieces(const Ground& ground, const PaddedGrid<std::int32_t>& names,
                               const TileParts& tiles, const std::vector<Contact>& contacts,
                               const RegionSet& set, const Checkpoint& checkpoint);

/// The same of names of which one may have cells in several pieces.
std::size_t count_pieces_by_rows(const Ground& ground, const PaddedGrid<std::int32_t>& names,
                                 const RegionSet& set, const Checkpoint& checkpoint);

}  // namespace stope::topology
