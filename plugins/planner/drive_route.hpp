#pragma once

#include <functional>
#include <optional>
#include <string_view>

#include "plugins/planner/curve_optimizer.hpp"
#include "plugins/planner/drivability.hpp"

namespace stope::planner {

struct DriveRequest {
  Vehicle vehicle;
  CurveWishes wishes;
  std::optional<double> start_heading, goal_heading;  ///< radians; none: as the route suggests
  double goal_tolerance = 5;  ///< metres by which the way may end early where the truck has no room
  bool allow_reverse = false;
};

/// A way along a route that the truck can drive: smooth where that is possible, with words of arcs
/// and straights where it is not. Throws Error, a sentence with the place and the reason, if there
/// is none.
DriveCurve drive_route(const RouteLine& line, const OccupancyGrid& grid,
                       const ElevationGrid* elevation, const DriveRequest& request,
                       const std::function<void(std::string_view)>& say,
                       const std::function<void()>& checkpoint);

}  // namespace stope::planner
