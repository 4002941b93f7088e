#pragma once

#include <cstdint>
#include <vector>

#include "plugins/planner/road_changes.hpp"
#include "plugins/planner/road_network.hpp"

namespace stope::planner {

/// The cost of driving from `start` to each node, infinite where there is no way. `against` turns
/// all directions round: the cost from each node to `start`.
std::vector<double> costs_from(const RoadNetwork& network, RoadPlace start, bool against = false,
                               const RoadChanges& changes = {});

}  // namespace stope::planner
