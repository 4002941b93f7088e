#pragma once

#include <vector>

#include "plugins/planner/drivability.hpp"
#include "stope/payloads/path.hpp"

namespace stope::planner {

/// Points along a curve, no farther apart than `step`, with height, heading, curvature and
/// clearance of the outline; speeds are left out. Where curvature jumps or the direction changes
/// there is a point, with the curvature of the way before it.
std::vector<PathPoint> drive_points(const DriveCurve& curve, const Drivability& ground,
                                    const ElevationGrid* elevation, double step);

/// How often a curve changes direction.
std::size_t cusps_of(const DriveCurve& curve);

}  // namespace stope::planner
