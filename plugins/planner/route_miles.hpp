#pragma once

#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "plugins/planner/drivability.hpp"
#include "plugins/planner/goal_area.hpp"
#include "plugins/planner/speed_profile.hpp"
#include "stope/payloads/path.hpp"

namespace stope::planner {

struct MileRequest {
  Vehicle vehicle;
  SpeedLimits limits;
  std::optional<Pose2> start;  ///< where the truck stands; none: at the path's start
  std::vector<Pose2> goals;    ///< any of these will do; none: the path's end
  GoalArea goal_area;          ///< of which `goals` are samples: a path that ends in it stays
  bool allow_reverse = true;
  double join_within = 60;  ///< metres from the path's ends within which it is joined and left
  double step = 0.5;
};

/// A path that can be driven, with its first and last mile driven anew: from a pose to a place on
/// the path, and from a place on it to a goal. What lies between stays as it is. Throws Error, a
/// sentence, if the path itself bends more than the truck can, or no way to or from it is found.
Path add_miles(const Path& path, const OccupancyGrid& grid, const ElevationGrid* elevation,
               const MileRequest& request, const std::function<void(std::string_view)>& say,
               const std::function<void()>& checkpoint);

}  // namespace stope::planner
