#pragma once

#include "plugins/rasterizer/local_ground.hpp"
#include "stope/payloads/occupancy_grid.hpp"

namespace stope::rasterizer {

/// Fills unknown gaps that a spinning LiDAR leaves between its rings, at most `gap` metres wide.
/// Obstacles first, so that a berm seen with gaps stays closed: an unknown cell in the closing of
/// the occupied cells by a disc of that diameter becomes occupied. Then an unknown cell in the
/// closing of the free cells becomes free, unless the ground of the free cells around it differs by
/// more than `most_step` metres: that gap may hide an edge, and stays unknown.
void close_gaps(OccupancyGrid& grid, const LocalGround& ground, double gap, double most_step);

}  // namespace stope::rasterizer
