#pragma once

#include "plugins/road_source/route_assembly.hpp"
#include "plugins/road_source/route_index.hpp"

namespace stope::road_source {

/// Adds the edges that Stope did not write: each a road one way, or, with its opposite, one both
/// ways if both have the same speed limit and line. An edge's own line is kept where it runs from
/// its first node to its second, in either order; else it is straight, as nav2 takes it to be.
void add_drawn_roads(const RouteRecords& records, const RouteIndex& index, double clearance,
                     AssembledRoads& result);

}  // namespace stope::road_source
