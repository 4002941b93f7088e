#pragma once

#include <cstddef>
#include <vector>

#include "plugins/planner/vehicle.hpp"
#include "stope/about.hpp"
#include "stope/payloads/path.hpp"

namespace stope::planner {

struct SpeedLimits {
  double top = 10;          ///< m/s
  double lateral = 1;       ///< m/s², in bends
  double accelerate = 0.5;  ///< m/s²
  double brake = 0.7;       ///< m/s²
};

/// The limits as a stage's parameters; its Params derive from SpeedLimits.
template <class S>
void describe_speeds(About<S>& about) {
  about.param("max_speed", &SpeedLimits::top, "m/s", more_than(0.0), "Speed on straights.")
      .param("lateral_acceleration", &SpeedLimits::lateral, "m/s^2", more_than(0.0),
             "What bends may ask of the load.")
      .param("acceleration", &SpeedLimits::accelerate, "m/s^2", more_than(0.0),
             "On the way up to speed.")
      .param("braking", &SpeedLimits::brake, "m/s^2", more_than(0.0), "On the way to a stop.");
}

/// Fills the speeds of points along a drive, negative backwards. The truck stands at both ends,
/// where it changes direction and, unless its wheels turn at once, where curvature changes by more
/// between two points than they can turn on the way.
void plan_speeds(std::vector<PathPoint>& points, const Vehicle& vehicle, const SpeedLimits& limits);

/// How often the truck stands between its start and its end, where speeds are planned; several
/// points in a row are one standstill.
std::size_t standstills_of(const std::vector<PathPoint>& points);

}  // namespace stope::planner
