#pragma once

#include <cstdint>
#include <deque>
#include <limits>
#include <utility>
#include <vector>

#include "plugins/metric/graph_lines.hpp"
#include "stope/payloads/road_graph.hpp"

namespace stope::metric {

/// Lengths of shortest ways along a road graph, which is driven both ways whatever its directions
/// and closures say: it is the network that is measured. Dijkstra from nodes; rows are kept while
/// they fit into 256 MB.
class RoadDistances {
 public:
  static constexpr double kUnreachable = std::numeric_limits<double>::infinity();

  /// Both must outlive it and belong together.
  RoadDistances(const RoadGraph& graph, const GraphLines& lines);

  /// Metres from a place to each node; kUnreachable where that is more than `reach`.
  std::vector<double> to_nodes(RoadPlace place, double reach = kUnreachable) const;
  /// Metres between two places.
  double between(RoadPlace a, RoadPlace b);
  /// A node as a place on one of its roads; edge_count() as the edge if it has none.
  RoadPlace place_of_node(std::uint32_t node) const { return place_of_node_[node]; }
  bool has_road(std::uint32_t node) const {
    return place_of_node_[node].edge < lines_.edge_count();
  }

 private:
  struct Link {
    std::uint32_t node;
    double length;
  };
  using Start = std::pair<double, std::uint32_t>;  // metres, node
  std::vector<double> search(const std::vector<Start>& starts, double reach) const;
  const std::vector<double>& row(std::uint32_t node);

  const RoadGraph& graph_;
  const GraphLines& lines_;
  std::vector<std::uint32_t> first_link_;  // of each node, and one past the last
  std::vector<Link> links_;
  std::vector<RoadPlace> place_of_node_;
  std::vector<std::vector<double>> rows_;  // of each node; empty: not known
  std::deque<std::uint32_t> kept_;         // nodes with a row, oldest first
  std::size_t most_rows_ = 0;
};

}  // namespace stope::metric
