#pragma once

#include <string>

#include "plugins/planner/drivability.hpp"
#include "plugins/planner/route_line.hpp"

namespace stope::planner {

/// "(12.00, 34.50)"
std::string text_of_place(double x, double y);
/// "at (12.00, 34.50), 153.2 m along the route"
std::string text_of_place_on(const RouteLine& line, const Pose2& pose);

/// Says where and why a truck cannot drive, for an operator. `needs_radius` is the greatest radius
/// of arcs with which a way was found there; 0: none was.
std::string refusal(const RouteLine& line, const Obstruction& obstruction, const Vehicle& vehicle,
                    double needs_radius);

}  // namespace stope::planner
