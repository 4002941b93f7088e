#pragma once

#include <string>
#include <vector>

#include "stope/payloads/occupancy_grid.hpp"
#include "stope/random.hpp"

namespace stope::metric {

/// A grid as it is written, the top row first: '.' free, '#' occupied, '?' unknown.
OccupancyGrid draw_grid(const std::vector<std::string>& rows, double resolution = 1);

/// Cells that are obstacles with the given probability.
OccupancyGrid random_grid(Random& random, int width, int height, double obstacles);

/// A free rectangle with walls of one cell round it: `width` x `height` cells in all.
OccupancyGrid walled(int width, int height, double resolution = 1);

}  // namespace stope::metric
