#pragma once

#include <vector>

#include "plugins/planner/drivable_grid.hpp"
#include "plugins/planner/plan_ends.hpp"
#include "plugins/planner/road_router.hpp"
#include "stope/payloads/road_graph.hpp"

namespace stope::planner {

/// Metres beyond which clearance is not looked for off the roads.
constexpr double kFarthestClearance = 20;

/// Where a route leads: from the start over the middles of its roads to the goal. Off the roads
/// heights are those of the place where the road is met, and clearances the grid's (NaN if null).
std::vector<RoadVertex> line_of_route(const Route& route, const PlanEnds& ends,
                                      const RoadNetwork& network, const DrivableGrid* grid);

}  // namespace stope::planner
