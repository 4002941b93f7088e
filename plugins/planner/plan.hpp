#pragma once

#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "plugins/planner/requested_changes.hpp"
#include "plugins/planner/road_network.hpp"
#include "plugins/planner/road_router.hpp"
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
  RequestedChanges changes;
  bool shortcut = false;         ///< leaves the roads' middles where the grid allows a shorter way
  bool avoid_obstructed = true;  ///< roads on which the grid shows an obstacle are not driven
};

/// Plans path after path along the same roads. Keeps a reference to the graph.
class RoadPlanner {
 public:
  /// Throws Error if there is no road that can be driven.
  RoadPlanner(
      const RoadGraph& roads, const RoadRules& rules, RouteSearch search = RouteSearch::kAStar,
      const std::function<void()>& pause = [] {});
  /// `request.rules` are not looked at: those of the constructor hold. Else as plan_path().
  Path plan(const OccupancyGrid* grid, const PlanRequest& request,
            const std::function<void(std::string_view)>& say);

 private:
  RoadNetwork network_;
  RoadRouter router_;
};

/// Plans a path along the roads. `grid` may be null: then start and goal are joined to their
/// nearest roads by straight lines that nobody has checked. `say` is told what was chosen in the
/// operator's stead. Throws Error where start or goal cannot be used; the sentence names the
/// nearest place that can.
Path plan_path(const RoadGraph& roads, const OccupancyGrid* grid, const PlanRequest& request,
               const std::function<void(std::string_view)>& say);

}  // namespace stope::planner
