#pragma once

#include <string>
#include <vector>

#include "plugins/road_source/route_records.hpp"
#include "stope/payloads/road_graph.hpp"

namespace stope::road_source {

/// What is taken to be true of roads that the file says nothing about.
struct RouteDefaults {
  double clearance = 0;  ///< metres on either side
};

/// A road graph, and what the operator should know of it, a sentence each.
struct AssembledRoads {
  RoadGraph roads;
  std::vector<std::string> warnings;
};

/// Joins what a route file says into a canonical road graph: chains of parts that Stope wrote
/// become the roads they were, other pairs of opposite edges become roads both ways. `file` is what
/// errors call it. Throws Error, naming the feature, where ids are dangling or not unique and where
/// the parts of a road do not fit together.
AssembledRoads assemble(const RouteRecords& records, const RouteDefaults& defaults,
                        const std::string& file);

}  // namespace stope::road_source
