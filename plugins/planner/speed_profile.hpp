#pragma once

#include <vector>

#include "plugins/planner/vehicle.hpp"
#include "stope/payloads/path.hpp"

namespace stope::planner {

struct SpeedLimits {
  double top = 10;          ///< m/s
  double lateral = 1;       ///< m/s², in bends
  double accelerate = 0.5;  ///< m/s²
  double brake = 0.7;       ///< m/s²
};

/// Fills the speeds of points along a drive, negative backwards. The truck stands at both ends,
/// where it changes direction and, unless its wheels turn at once, where curvature changes by more
/// between two points than they can turn on the way.
void plan_speeds(std::vector<PathPoint>& points, const Vehicle& vehicle, const SpeedLimits& limits);

}  // namespace stope::planner
