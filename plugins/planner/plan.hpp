#pragma once

#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "plugins/planner/road_network.hpp"
#include "stope/payloads/occupancy_grid.hpp"
#include "stope/payloads/path.hpp"

namespace stope::planner {

/// Where from and where to, and how.
struct PlanRequest {
  std::optional<std::vector<double>> start, goal;  ///< [x, y], metres, map frame
  double snap_distance = 50;                       ///< metres from start or goal to a road, at most
  double step = 1;                                 ///< metres between points of the path, at most
  double smoothing = 2;                            ///< metres over which heading is taken
  RoadRules rules;
};

/// Plans a path along the roads. `grid` may be null: then start and goal are joined to their
/// nearest roads by straight lines that nobody has checked. `say` is told what was chosen in the
/// operator's stead. Throws Error where start or goal cannot be used; the sentence names the
/// nearest place that can.
Path plan_path(const RoadGraph& roads, const OccupancyGrid* grid, const PlanRequest& request,
               const std::function<void(std::string_view)>& say);

}  // namespace stope::planner
