#pragma once

#include "plugins/planner/drivable_grid.hpp"
#include "plugins/planner/plan_ends.hpp"
#include "plugins/planner/road_changes.hpp"
#include "plugins/planner/road_router.hpp"

namespace stope::planner {

/// The cheapest way between two ends whose roads a grid shows free. Roads that it shows obstructed
/// are cut in `changes`; they and the first such place are said. `grid` is null where nobody is to
/// look. Throws Error, the sentence of PlanEnds::refuse_goal(), if there is no way.
Route unobstructed_route(RoadRouter& router, const RoadNetwork& network, const DrivableGrid* grid,
                         const PlanEnds& ends, RoadChanges& changes, const Say& say);

}  // namespace stope::planner
