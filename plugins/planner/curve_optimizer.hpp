#pragma once

#include <functional>
#include <optional>

#include "plugins/planner/clearance_field.hpp"
#include "plugins/planner/drive_curve.hpp"
#include "plugins/planner/route_line.hpp"
#include "plugins/planner/vehicle.hpp"

namespace stope::planner {

/// What a good drive is, in metres of straight driving each.
struct CurveWishes {
  double comfortable_clearance = 3;  ///< metres beyond the margin that are worth a detour
  double bend = 150;                 ///< a metre driven with a curvature of 1/m, squared
  double steer = 4000;      ///< a metre driven with a change of curvature of 1/m², squared
  double near_wall = 0.04;  ///< a metre driven with 1 m too little comfort, squared, a circle
  double off_line = 0.002;  ///< a metre driven 1 m off the line, squared
};

struct CurveRequest {
  bool free_heading = false;          ///< the start's heading may be chosen
  bool start_curvature_held = false;  ///< that of `first`; else the wheels may stand otherwise
  Vector2 goal = Vector2::Zero();
  std::optional<double> goal_heading;  ///< radians
  double obstacle_weight = 50;         ///< as near_wall, of the margin itself
  int most_rounds = 40;
};

/// The best drive near a first one: no piece's curvature exceeds the truck's, none changes faster
/// than its wheels turn, curvature is continuous. Obstacles are pushed away from, not checked.
/// `first` has pieces with continuous curvature, forwards only. It ends near the goal, by
/// millimetres unless something is in the way.
DriveCurve optimize_curve(const DriveCurve& first, const RouteLine& line, const Vehicle& vehicle,
                          const ClearanceField& field, const CurveRequest& request,
                          const CurveWishes& wishes, const std::function<void()>& checkpoint);

}  // namespace stope::planner
