#pragma once

#include <optional>
#include <utility>

#include "plugins/planner/road_network.hpp"

namespace stope::planner {

/// Two nodes of the largest connected part of the network that lie far apart by road: the last two
/// of a double sweep (the node farthest from the part's first node, then the one farthest from
/// that). None if no road can be driven. O(E log V).
std::optional<std::pair<RoadPlace, RoadPlace>> far_ends(const RoadNetwork& network);

/// The node that costs most to reach from `start` (or, `against`, to come to it from).
RoadPlace farthest_from(const RoadNetwork& network, RoadPlace start, bool against);

}  // namespace stope::planner
