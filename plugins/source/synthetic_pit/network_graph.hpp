#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "plugins/source/synthetic_pit/street_network.hpp"

namespace stope::source {

/// The street network cut at its junctions: what a truck decides on, and what the true road graph
/// shows.
struct NetworkGraph {
  struct Node {
    Vector2 place = Vector2::Zero();
    double elevation = 0;
    std::optional<std::size_t> dead_end;  ///< in StreetNetwork::dead_ends
  };
  struct Edge {
    std::size_t from = 0, to = 0;
    double width = 0;
    std::vector<Vector2> points;  ///< from node to node, both included
    std::vector<double> elevation;
  };
  std::vector<Node> nodes;
  std::vector<Edge> edges;
};

NetworkGraph cut_at_junctions(const StreetNetwork& network);

}  // namespace stope::source
