#pragma once

#include <string>

#include "plugins/planner/drivability.hpp"
#include "plugins/planner/route_line.hpp"

namespace stope::planner {

/// "(12.00, 34.50)"
std::string text_of_place(double x, double y);
/// "at (12.00, 34.50), 153.2 m along the route"
std::string text_of_place_on(const RouteLine& line, const Pose2& pose);

/// What was found out about a place where a truck cannot drive.
struct Remedies {
  double radius = 0;         ///< greatest radius of arcs with which a way was found; 0: none was
  double least_tried = 0;    ///< the least radius that was tried
  bool may_reverse = false;  ///< the truck may already
  bool reversing = false;    ///< with it a way was found
};

/// Says where and why a truck cannot drive, and what would help, for an operator.
std::string refusal(const RouteLine& line, const Obstruction& obstruction, const Vehicle& vehicle,
                    const Remedies& remedies);

}  // namespace stope::planner
