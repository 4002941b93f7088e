#pragma once

#include <optional>
#include <string>
#include <vector>

#include "plugins/planner/path_sampling.hpp"
#include "plugins/planner/plan.hpp"
#include "stope/stope.hpp"

namespace stope::planner {

/// The parameters that all planners have.
struct PlannerParams {
  std::optional<std::vector<double>> start, goal;
  double snap_distance = 50;
  double min_clearance = 0;
  double comfortable_clearance = 10;
  double clearance_weight = 0;
  double step = 1;
  double smoothing = 2;
  std::vector<double> closed_places, slow_places;
  std::vector<std::string> closed_roads;
  bool avoid_obstructed = true, shortcut = false;
};

/// Declares them and the family's ports, in one order for all.
template <class S>
About<S>& describe_planner(About<S>& about) {
  using Params = PlannerParams;
  return about.ports("roads", "pose", "grid", "path")
      .param("start", &Params::start, "m", count(2, 2),
             "Where to start, [x, y] in the map frame; a wired pose comes before it.")
      .param("goal", &Params::goal, "m", count(2, 2), "Where to go, [x, y] in the map frame.")
      .param("snap_distance", &Params::snap_distance, "m", at_least(0.0),
             "How far start and goal may lie from a road.")
      .param("min_clearance", &Params::min_clearance, "m", at_least(0.0),
             "Roads that come nearer to an obstacle than this are not driven.")
      .param("comfortable_clearance", &Params::comfortable_clearance, "m", at_least(0.0),
             "Beyond this clearance a road costs no more than its length.")
      .param("clearance_weight", &Params::clearance_weight, at_least(0.0),
             "How much dearer a metre without any clearance is; 0 plans the shortest way.")
      .param("step", &Params::step, "m", at_least(kLeastStep), "Greatest distance between points.")
      .param("smoothing", &Params::smoothing, "m", more_than(0.0),
             "Distance before and behind a point over which heading and curvature are taken.")
      .param("closed_places", &Params::closed_places, "m", any(),
             "Places [x, y, x, y, …] where the nearest road cannot be passed now, nor others that "
             "meet it there.")
      .param("closed_roads", &Params::closed_roads, "Ids of road edges that are closed now.")
      .param("slow_places", &Params::slow_places,
             "[x, y, factor, …]: the road nearest to (x, y) costs factor times as much now.")
      .param("avoid_obstructed", &Params::avoid_obstructed,
             "Whether to drive round roads on which the grid shows an obstacle now.")
      .param("shortcut", &Params::shortcut,
             "Whether to leave the middle of the roads where the grid allows a shorter way: "
             "pulled straight, not past corners, min_clearance kept.");
}

/// What is asked of a planner for one item.
PlanRequest request_of(const PlannerParams& params, const Optional<StampedPose>& pose);

/// Says how long a path is.
void say_planned(const Path& path, Context& context);

}  // namespace stope::planner
