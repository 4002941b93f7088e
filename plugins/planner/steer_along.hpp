#pragma once

#include <optional>

#include "plugins/planner/drive_curve.hpp"
#include "plugins/planner/route_line.hpp"
#include "plugins/planner/vehicle.hpp"

namespace stope::planner {

/// Drives along a line as a simple driver would: always towards the place `look_ahead` metres
/// further (pure pursuit, Coulter 1992), the wheels no faster and no further than they go. Pieces
/// of about a metre, with continuous curvature, `start_curvature` at first. None if the truck does
/// not come past the line's end. It looks at no obstacle.
std::optional<DriveCurve> steer_along(const RouteLine& line, const Pose2& start,
                                      const Vehicle& vehicle, double look_ahead,
                                      double start_curvature = 0);

}  // namespace stope::planner
