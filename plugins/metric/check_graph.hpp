#pragma once

#include <string>

#include "stope/payloads/road_graph.hpp"

namespace stope::metric {

/// Throws Error unless all edges of `graph` name nodes and vertices that exist and all coordinates
/// are numbers. `port` names the graph in the sentence.
void check_graph(const RoadGraph& graph, const std::string& port);

/// The same for a true graph, which must also have roads: there is nothing to measure against one
/// without.
void check_truth(const RoadGraph& truth);

}  // namespace stope::metric
