#pragma once

#include <vector>

#include "plugins/planner/drivable_grid.hpp"
#include "plugins/planner/plan_ends.hpp"
#include "plugins/planner/road_changes.hpp"
#include "plugins/planner/road_router.hpp"

namespace stope::planner {

/// The route, or another that is nearly as cheap, pulled straight through free ground. Heights come
/// from the route's `line` beside it; that is returned where no shorter way is found.
std::vector<RoadVertex> shortened_route(const Route& route, std::vector<RoadVertex> line,
                                        RoadRouter& router, const RoadNetwork& network,
                                        const DrivableGrid& grid, const PlanEnds& ends,
                                        const RoadChanges& changes);

}  // namespace stope::planner
