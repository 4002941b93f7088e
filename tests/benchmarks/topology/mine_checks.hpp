#pragma once

#include "stope/payloads/occupancy_grid.hpp"

namespace stope::topology {

/// Prints, for every extractor on the real mine, whether its roads have as many independent cycles
/// as free space has holes of at least each of the holes' own areas, and how much of the recorded
/// tracks lies within the roads' clearance. Returns whether all is as it must be.
bool check_mine(const OccupancyGrid& mine);

}  // namespace stope::topology
