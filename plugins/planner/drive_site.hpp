#pragma once

#include <functional>
#include <optional>

#include "plugins/planner/curve_optimizer.hpp"
#include "plugins/planner/drivability.hpp"
#include "plugins/planner/route_line.hpp"

namespace stope::planner {

struct DriveRequest {
  Vehicle vehicle;
  CurveWishes wishes;
  std::optional<double> start_heading, goal_heading;  ///< radians; none: as the route suggests
  double goal_tolerance = 5;  ///< metres by which the way may end early where the truck has no room
  bool allow_reverse = false;
};

/// Where a truck is to drive, and how: what all parts of driving along a route look at.
struct DriveSite {
  /// Metres around a route, and around the part of it that is driven anew, where ways are sought.
  static constexpr double kAround = 45;

  const OccupancyGrid& grid;
  const ElevationGrid* elevation;  ///< may be null
  const ClearanceField& field;     ///< field_around() the route
  const DriveRequest& request;
  const std::function<void()>& checkpoint;
  Drivability ground{request.vehicle, grid, field, elevation};
};

/// How far obstacles are around a route, as far as driving along it has to know.
ClearanceField field_around(const RouteLine& line, const OccupancyGrid& grid,
                            const DriveRequest& request);

}  // namespace stope::planner
