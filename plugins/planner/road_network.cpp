#include "plugins/planner/road_network.hpp"

#include <algorithm>
#include <cmath>

namespace stope::planner {
namespace {

double discomfort(double clearance, const RoadRules& rules) {
  if (!(rules.comfortable_clearance > 0) || std::isnan(clearance)) return 0;
  return std::clamp(1 - clearance / rules.comfortable_clearance, 0.0, 1.0);
}

double mix(double a, double b, double fraction) { return a + fraction * (b - a); }

}  // namespace

RoadNetwork::RoadNetwork(const RoadGraph& graph, const RoadRules& rules)
    : graph_(graph),
      rules_(rules),
      along_(graph.vertices.size()),
      cost_(graph.vertices.size()),
      usable_(graph.edges.size()) {
  for (std::size_t e = 0; e < graph.edges.size(); ++e) {
    const RoadEdge& edge = graph.edges[e];
    usable_[e] =
        edge.closed == 0 && edge.vertex_count >= 2 && !(edge.min_clearance < rules.min_clearance);
    for (std::uint32_t v = edge.first_vertex + 1; v < edge.first_vertex + edge.vertex_count; ++v) {
      const RoadVertex &a = graph.vertices[v - 1], &b = graph.vertices[v];
      const double step = std::hypot(b.x - a.x, b.y - a.y);
      const double penalty =
          0.5 * (discomfort(a.clearance, rules) + discomfort(b.clearance, rules));
      along_[v] = along_[v - 1] + step;
      cost_[v] = cost_[v - 1] + step * (1 + rules.clearance_weight * penalty);
    }
  }
  out_ = make_adjacency(false);
  in_ = make_adjacency(true);
}

std::uint32_t RoadNetwork::segment_end(std::uint32_t edge, double along) const {
  const auto begin = along_.begin() + graph_.edges[edge].first_vertex + 1;
  const auto end = along_.begin() + last(edge);
  return static_cast<std::uint32_t>(std::lower_bound(begin, end, along) - along_.begin());
}

double RoadNetwork::cost_until(std::uint32_t edge, double along) const {
  const std::uint32_t v = segment_end(edge, along);
  const double step = along_[v] - along_[v - 1];
  const double fraction = step > 0 ? std::clamp((along - along_[v - 1]) / step, 0.0, 1.0) : 0;
  return mix(cost_[v - 1], cost_[v], fraction);
}

double RoadNetwork::cost(std::uint32_t edge, double from, double to) const {
  return std::abs(cost_until(edge, to) - cost_until(edge, from));
}

RoadVertex RoadNetwork::at(RoadPlace place) const {
  const std::uint32_t v = segment_end(place.edge, place.along);
  const RoadVertex &a = graph_.vertices[v - 1], &b = graph_.vertices[v];
  const double step = along_[v] - along_[v - 1];
  const double fraction = step > 0 ? std::clamp((place.along - along_[v - 1]) / step, 0.0, 1.0) : 0;
  return {mix(a.x, b.x, fraction), mix(a.y, b.y, fraction), mix(a.z, b.z, fraction),
          mix(a.clearance, b.clearance, fraction)};
}

RoadPlace RoadNetwork::node_place(std::uint32_t node) const {
  for (std::uint32_t e = 0; e < graph_.edges.size(); ++e) {
    if (!usable_[e]) continue;
    if (graph_.edges[e].from == node) return {e, 0};
    if (graph_.edges[e].to == node) return {e, length(e)};
  }
  return {static_cast<std::uint32_t>(graph_.edges.size()), 0};
}

RoadNetwork::Adjacency RoadNetwork::make_adjacency(bool into) const {
  struct Listed {
    std::uint32_t node;
    Arc arc;
  };
  std::vector<Listed> listed;
  for (std::uint32_t e = 0; e < graph_.edges.size(); ++e) {
    const RoadEdge& edge = graph_.edges[e];
    const double whole = usable_[e] ? cost_[last(e)] : 0;
    if (forward(e))
      listed.push_back(into ? Listed{edge.to, {e, edge.from, whole}}
                            : Listed{edge.from, {e, edge.to, whole}});
    if (backward(e))
      listed.push_back(into ? Listed{edge.from, {e, edge.to, whole}}
                            : Listed{edge.to, {e, edge.from, whole}});
  }
  std::stable_sort(listed.begin(), listed.end(),
                   [](const Listed& a, const Listed& b) { return a.node < b.node; });
  Adjacency adjacency;
  adjacency.first.assign(graph_.nodes.size() + 1, 0);
  for (const Listed& entry : listed) {
    ++adjacency.first[entry.node + 1];
    adjacency.arcs.push_back(entry.arc);
  }
  for (std::size_t i = 1; i < adjacency.first.size(); ++i)
    adjacency.first[i] += adjacency.first[i - 1];
  return adjacency;
}

}  // namespace stope::planner
