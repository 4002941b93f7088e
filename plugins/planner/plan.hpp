#pragma once

#include <functional>

#include "plugins/planner/plan_request.hpp"
#include "plugins/planner/road_network.hpp"
#include "plugins/planner/road_router.hpp"
#include "stope/payloads/occupancy_grid.hpp"
#include "stope/payloads/path.hpp"

namespace stope::planner {

/// Plans path after path along the same roads. Keeps a reference to the graph.
class RoadPlanner {
 public:
  /// Throws Error if the graph is damaged or has no road that can be driven.
  RoadPlanner(
      const RoadGraph& roads, const RoadRules& rules, RouteSearch search = RouteSearch::kAStar,
      const std::function<void()>& pause = [] {});
  /// `request.rules` are not looked at: those of the constructor hold. Else as plan_path().
  Path plan(const OccupancyGrid* grid, const PlanRequest& request, const Say& say);
  /// The request with what it leaves out of start and goal chosen as plan() would, which is said:
  /// for planners that add roads to the graph, of which a far end must be none.
  PlanRequest with_ends(const OccupancyGrid& grid, const PlanRequest& request,
                        const Say& say) const;

 private:
  RoadNetwork network_;
  RoadRouter router_;
};

/// Plans a path along the roads. `grid` may be null: then start and goal are joined to their
/// nearest roads by straight lines that nobody has checked. `say` is told what was chosen in the
/// operator's stead. Throws Error where start or goal cannot be used; the sentence names the
/// nearest place that can.
Path plan_path(const RoadGraph& roads, const OccupancyGrid* grid, const PlanRequest& request,
               const Say& say);

}  // namespace stope::planner
