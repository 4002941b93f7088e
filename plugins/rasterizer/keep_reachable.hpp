#pragma once

#include "stope/payloads/occupancy_grid.hpp"
#include "stope/payloads/trajectory.hpp"

namespace stope::rasterizer {

/// Keeps the free cells that a vehicle `passage` metres wide covers while it moves clear of
/// obstacles over free ground, from where the trajectory passes; other free cells become unknown.
/// Unknown holes narrower than half a passage do not stop it, and along the route nothing does.
/// Returns false, and changes nothing, if the route does not touch the grid.
bool keep_reachable(OccupancyGrid& grid, const Trajectory& trajectory, double passage);

}  // namespace stope::rasterizer
