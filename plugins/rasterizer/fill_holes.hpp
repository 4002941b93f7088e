#pragma once

#include "plugins/rasterizer/local_ground.hpp"
#include "stope/payloads/occupancy_grid.hpp"

namespace stope::rasterizer {

/// Frees unknown holes of at most `most_area` square metres that free cells enclose: 8-connected
/// unknown cells that touch neither an obstacle nor the grid's edge. A hole across which the ground
/// differs by more than `most_step` plus `slope` times the hole's width may hide an edge and stays.
void fill_holes(OccupancyGrid& grid, const LocalGround& ground, double most_area, double most_step,
                double slope);

}  // namespace stope::rasterizer
