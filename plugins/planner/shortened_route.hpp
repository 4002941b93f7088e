#pragma once

#include <vector>

#include "plugins/planner/drivable_grid.hpp"
#include "plugins/planner/plan_request.hpp"
#include "plugins/planner/road_changes.hpp"
#include "plugins/planner/road_network.hpp"

namespace stope::planner {

/// The way from the first to the last place of a route's `line` that leaves the roads' middles
/// wherever free ground allows a shorter one; road_ground.hpp says which ground it may use. Heights
/// come from the line beside it. The line itself where there is no shorter way, or where the ground
/// is too large to be searched, which is said.
std::vector<RoadVertex> shortened_route(std::vector<RoadVertex> line, const RoadNetwork& network,
                                        const DrivableGrid& grid, const RoadChanges& changes,
                                        const Say& say);

}  // namespace stope::planner
