#pragma once

#include <vector>

#include "stope/geometry.hpp"

namespace stope::report {

/// A polyline with fewer points that nowhere strays further than `tolerance` from the given one
/// (Douglas and Peucker, 1973). Keeps both ends; points that are not finite are left out.
std::vector<Vector2> simplified(std::vector<Vector2> line, double tolerance);

/// Half a pixel of a picture of that extent: what no one will miss.
double half_a_pixel(const std::vector<Vector2>& points);

}  // namespace stope::report
