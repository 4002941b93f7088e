#pragma once

#include "plugins/source/synthetic_pit/checkpoint.hpp"
#include "plugins/source/synthetic_pit/machines.hpp"
#include "plugins/source/synthetic_pit/network_graph.hpp"
#include "plugins/source/synthetic_pit/terrain.hpp"
#include "stope/payloads/elevation_grid.hpp"
#include "stope/payloads/occupancy_grid.hpp"
#include "stope/payloads/road_graph.hpp"

namespace stope::source {

/// Where a truck can drive: free or occupied, nothing unknown.
OccupancyGrid true_grid(const Terrain& terrain);

/// The ground without machines.
ElevationGrid true_elevation(const Terrain& terrain);

/// The roads as designed, with clearances measured on the true grid (to the edge of the nearest
/// obstacle cell). The node of a dead end is the centre of its turning place.
RoadGraph true_roads(const NetworkGraph& graph, const Terrain& terrain,
                     const Checkpoint& checkpoint = never_stop);

}  // namespace stope::source
