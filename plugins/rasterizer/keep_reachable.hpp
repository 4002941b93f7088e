#pragma once

#include "stope/payloads/occupancy_grid.hpp"
#include "stope/payloads/trajectory.hpp"

namespace stope::rasterizer {

/// Keeps the free cells that a disc of diameter `passage` metres covers while it moves over free
/// cells, from where the trajectory passes; other free cells become unknown. Returns false, and
/// changes nothing, if the disc finds no place along the trajectory.
bool keep_reachable(OccupancyGrid& grid, const Trajectory& trajectory, double passage);

}  // namespace stope::rasterizer
