#pragma once

#include <utility>
#include <vector>

#include "stope/payloads/occupancy_grid.hpp"
#include "stope/payloads/path.hpp"

namespace stope::planner {

using Places = std::vector<std::pair<double, double>>;

/// A path along these places, without anything else.
Path path_of(const Places& places);

/// Free ground of so many cells of half a metre.
OccupancyGrid free_ground(std::int32_t width, std::int32_t height);

/// 210 x 130 m at half a metre, free where it is within half a `width` of one of the lines. With
/// `round` roads end in half circles, else squarely, so that corners are sharp.
OccupancyGrid roads_of(double width, const std::vector<Places>& lines, bool round = true);

/// Gives the cells whose centres lie in a box a value.
void fill(OccupancyGrid& grid, double left, double bottom, double right, double top,
          std::uint8_t value);

}  // namespace stope::planner
