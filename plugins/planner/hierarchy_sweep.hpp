#pragma once

#include <cstdint>
#include <vector>

#include "plugins/planner/contraction_hierarchy.hpp"

namespace stope::planner {

/// What each node costs to reach from one, or with `against` to come from to it; kNoWay where there
/// is no way. Nodes by rank. See the .cpp for method and cost.
std::vector<WayCost> sweep_costs(const ContractionHierarchy& hierarchy, std::uint32_t rank,
                                 bool against);

}  // namespace stope::planner
