#include "plugins/planner/planner_params.hpp"

#include <fmt/format.h>

namespace stope::planner {

PlanRequest request_of(const PlannerParams& params, const Optional<StampedPose>& pose) {
  PlanRequest request;
  request.start = params.start;
  request.goal = params.goal;
  if (pose) {
    const auto& place = pose->T_map_lidar.translation;
    request.start = {place.x(), place.y()};
  }
  request.snap_distance = params.snap_distance;
  request.step = params.step;
  request.smoothing = params.smoothing;
  request.rules = {params.min_clearance, params.comfortable_clearance, params.clearance_weight};
  request.changes = {params.closed_places, params.closed_roads, params.slow_places};
  request.avoid_obstructed = params.avoid_obstructed;
  request.shortcut = params.shortcut;
  return request;
}

void say_planned(const Path& path, Context& context) {
  context.info(fmt::format("planned {:.1f} m along {} {}", path.length, path.edges.size(),
                           path.edges.size() == 1 ? "road" : "roads"));
}

}  // namespace stope::planner
