#pragma once

#include <vector>

#include "stope/payloads/occupancy_grid.hpp"

namespace stope::prior {

/// Marks with `value` the cells whose centre lies within `radius` metres of a polyline. Exact: the
/// dilation of the line by a disc. O(rows of each segment's box).
void dilate_track(OccupancyGrid& grid, const std::vector<Vector2>& line, double radius,
                  std::uint8_t value);

}  // namespace stope::prior
