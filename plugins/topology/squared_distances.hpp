#pragma once

#include "plugins/topology/free_space.hpp"

namespace stope::topology {

/// The exact Euclidean distance transform: for every cell, margin apart, the squared distance to
/// the nearest obstacle cell, from centre to centre, in cells; 0 in obstacles. Outside of the map
/// all are obstacles. Which obstacle that is, find_nearest_outline tells.
void find_squared_distances(const FreeSpace& space, PaddedGrid<std::uint32_t>& distances,
                            const Checkpoint& checkpoint = never_stop);

}  // namespace stope::topology
