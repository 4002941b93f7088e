#pragma once

#include <cstddef>
#include <vector>

#include "plugins/source/synthetic_pit/checkpoint.hpp"
#include "plugins/source/synthetic_pit/network_graph.hpp"
#include "plugins/source/synthetic_pit/network_rules.hpp"

namespace stope::source {

/// An edge driven in a direction.
struct Leg {
  std::size_t edge = 0;
  bool backward = false;
};

/// A drive over every edge that can be reached, always on to the nearest one not yet driven. A
/// truck turns round only in turning places. Begins with the last dead end, or anywhere if there
/// is none; every turning place is driven round.
std::vector<Leg> covering_route(const NetworkGraph& graph,
                                const Checkpoint& checkpoint = never_stop);

/// The legs as one smooth line in steps of kRouteStep: corners are rounded inside the junctions,
/// turning places are left by a loop of kTurningRadius.
std::vector<Vector2> route_line(const StreetNetwork& network, const NetworkGraph& graph,
                                const std::vector<Leg>& legs, const NetworkRules& rules,
                                const Checkpoint& checkpoint = never_stop);

inline constexpr double kRouteStep = 0.5;       ///< metres
inline constexpr double kTurningRadius = 12.5;  ///< metres; a 9 m haul truck needs 12

}  // namespace stope::source
