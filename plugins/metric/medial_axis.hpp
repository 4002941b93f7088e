#pragma once

#include <vector>

#include "plugins/metric/free_cells.hpp"

namespace stope::metric {

/// Points of the medial axis, in metres of the map frame: wherever two neighbouring cells see
/// different nearest obstacle cells, the place between their centres that is equally far from both,
/// if it sees them at an angle that is, to the resolution, at least `min_angle` radians and from at
/// least `min_clearance` metres (to the edge of an obstacle cell, half a cell before its centre).
/// In raster order.
///
/// The angle is what parts roads from notches: between parallel walls it is 180 degrees, in a
/// right-angled corner 90, and the smaller the shallower a dent is (the theta-simplified medial
/// axis of Foskey, Lin and Manocha 2003).
std::vector<Vector2> medial_axis(const FreeCells& cells, double min_angle, double min_clearance);

}  // namespace stope::metric
