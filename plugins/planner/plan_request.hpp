#pragma once

#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "plugins/planner/requested_changes.hpp"
#include "plugins/planner/road_network.hpp"

namespace stope::planner {

/// Where from and where to, and how.
struct PlanRequest {
  std::optional<std::vector<double>> start, goal;  ///< [x, y], metres, map frame
  /// Where start and goal lie on the network if they are not given.
  std::optional<RoadPlace> start_place, goal_place;
  double snap_distance = 50;  ///< metres from start or goal to a road, at most
  double step = 1;            ///< metres between points of the path, at most
  double smoothing = 2;       ///< metres over which heading is taken
  RoadRules rules;
  RequestedChanges changes;
  bool shortcut = false;         ///< leaves the roads' middles where the grid allows a shorter way
  bool avoid_obstructed = true;  ///< roads on which the grid shows an obstacle are not driven
};

/// Is told, in sentences, what a plan chose in the operator's stead.
using Say = std::function<void(std::string_view)>;

}  // namespace stope::planner
