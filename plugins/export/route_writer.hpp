#pragma once

#include <string>

#include "stope/payloads/road_graph.hpp"

namespace stope::exports {

/// What a route file is written with.
struct RouteStyle {
  std::string frame = "map";  ///< the frame of the coordinates
  double tolerance = 0;       ///< metres a chain may stray from its road
};

/// A road graph as the GeoJSON that nav2's route server loads, from which road_source/nav2_route
/// makes the same graph again. Throws Error where the graph cannot be written so: ids that are not
/// unique, places that are not finite, more parts than nav2 has ids.
std::string route_geojson(const RoadGraph& graph, const RouteStyle& style);

}  // namespace stope::exports
