#pragma once

#include "stope/payloads/occupancy_grid.hpp"
#include "stope/payloads/trajectory.hpp"

namespace stope::rasterizer {

/// Frees the cells whose centre lies within half of `width` metres of the route (looked at every
/// half cell): where the vehicle itself was, there is no obstacle that stays.
void free_driven(OccupancyGrid& grid, const Trajectory& trajectory, double width);

}  // namespace stope::rasterizer
