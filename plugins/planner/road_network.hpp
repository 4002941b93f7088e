#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "stope/payloads/road_graph.hpp"

namespace stope::planner {

/// What driving costs: metres, made dearer near obstacles.
struct RoadRules {
  double min_clearance = 0;          ///< metres; narrower roads are not driven
  double comfortable_clearance = 0;  ///< metres; beyond it clearance does not matter
  double clearance_weight = 0;       ///< a metre with no clearance costs 1 + this
};

/// A place on a road: metres along the edge's polyline.
struct RoadPlace {
  std::uint32_t edge = 0;
  double along = 0;
};

/// A road out of a node, in a direction it may be driven.
struct Arc {
  std::uint32_t edge = 0, to = 0;
  double cost = 0;
};

/// A road graph made ready for search: costs along every polyline, and the arcs out of and into
/// each node in two flat arrays. Closed and too narrow roads are left out. Keeps a reference to the
/// graph.
class RoadNetwork {
 public:
  RoadNetwork(const RoadGraph& graph, const RoadRules& rules);

  const RoadGraph& graph() const { return graph_; }
  const RoadRules& rules() const { return rules_; }
  bool usable(std::uint32_t edge) const { return usable_[edge]; }
  bool forward(std::uint32_t edge) const {
    return usable(edge) && graph_.edges[edge].direction != RoadDirection::kBackward;
  }
  bool backward(std::uint32_t edge) const {
    return usable(edge) && graph_.edges[edge].direction != RoadDirection::kForward;
  }
  double length(std::uint32_t edge) const { return along_[last(edge)]; }
  /// Metres from the start of the edge's polyline to a vertex of RoadGraph::vertices.
  double along(std::uint32_t vertex) const { return along_[vertex]; }
  /// Cost of driving an edge between two places of it, either way. At least the distance.
  double cost(std::uint32_t edge, double from, double to) const;
  /// What a place looks like, between its vertices linear.
  RoadVertex at(RoadPlace place) const;
  /// The place of a node, on the first usable road that touches it; that road's number is past the
  /// end if there is none.
  RoadPlace node_place(std::uint32_t node) const;

  std::span<const Arc> arcs_from(std::uint32_t node) const { return arcs(out_, node); }
  /// Roads into the node; Arc::to is where they come from.
  std::span<const Arc> arcs_into(std::uint32_t node) const { return arcs(in_, node); }

 private:
  struct Adjacency {
    std::vector<std::uint32_t> first;  // node_count + 1
    std::vector<Arc> arcs;
  };
  static std::span<const Arc> arcs(const Adjacency& adjacency, std::uint32_t node) {
    return std::span(adjacency.arcs)
        .subspan(adjacency.first[node], adjacency.first[node + 1] - adjacency.first[node]);
  }
  std::uint32_t last(std::uint32_t edge) const {
    return graph_.edges[edge].first_vertex + graph_.edges[edge].vertex_count - 1;
  }
  double cost_until(std::uint32_t edge, double along) const;
  std::uint32_t segment_end(std::uint32_t edge, double along) const;
  Adjacency make_adjacency(bool into) const;

  const RoadGraph& graph_;
  RoadRules rules_;
  std::vector<double> along_, cost_;  // of each vertex, from the start of its edge
  std::vector<bool> usable_;          // of each edge
  Adjacency out_, in_;
};

}  // namespace stope::planner
