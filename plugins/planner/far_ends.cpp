#include "plugins/planner/far_ends.hpp"

#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include "plugins/planner/road_search.hpp"

namespace stope::planner {
namespace {

/// The lowest node of the connected part (directions aside) with the greatest length of road.
std::optional<std::uint32_t> node_of_largest_part(const RoadNetwork& network) {
  const RoadGraph& graph = network.graph();
  std::vector<std::uint32_t> parent(graph.nodes.size());
  std::iota(parent.begin(), parent.end(), 0U);
  const auto root = [&](std::uint32_t node) {
    while (parent[node] != node) node = parent[node] = parent[parent[node]];
    return node;
  };
  for (std::uint32_t e = 0; e < graph.edges.size(); ++e) {
    if (!network.usable(e)) continue;
    const std::uint32_t a = root(graph.edges[e].from), b = root(graph.edges[e].to);
    parent[std::max(a, b)] = std::min(a, b);
  }
  std::vector<double> lengths(graph.nodes.size(), 0);
  std::optional<std::uint32_t> best;
  for (std::uint32_t e = 0; e < graph.edges.size(); ++e) {
    if (network.usable(e)) lengths[root(graph.edges[e].from)] += network.length(e);
  }
  for (std::uint32_t node = 0; node < lengths.size(); ++node) {
    if (lengths[node] > 0 && (!best || lengths[node] > lengths[*best])) best = node;
  }
  return best;
}

std::pair<std::uint32_t, double> farthest_node(const std::vector<double>& costs) {
  std::pair<std::uint32_t, double> best{0, -1};
  for (std::uint32_t node = 0; node < costs.size(); ++node) {
    if (std::isfinite(costs[node]) && costs[node] > best.second) best = {node, costs[node]};
  }
  return best;
}

/// Halfway along the longest road that leaves (or, `against`, enters) a node without cost; only
/// rings do, if no node costs anything. `start` if there is no such road.
FarPlace across_longest_ring(const RoadNetwork& network, RoadPlace start,
                             const std::vector<double>& costs, bool against) {
  FarPlace best{start, false};
  double longest = 0;
  for (std::uint32_t node = 0; node < costs.size(); ++node) {
    if (!std::isfinite(costs[node])) continue;
    for (const Arc& arc : against ? network.arcs_into(node) : network.arcs_from(node)) {
      const double length = network.length(arc.edge);
      if (length <= longest) continue;
      longest = length;
      best = {{arc.edge, length / 2}, true};
    }
  }
  return best;
}

}  // namespace

FarPlace farthest_from(const RoadNetwork& network, RoadPlace start, bool against) {
  const std::vector<double> costs = costs_from(network, start, against);
  const auto [node, cost] = farthest_node(costs);
  if (cost > 0) return {network.node_place(node), false};
  return across_longest_ring(network, start, costs, against);
}

std::optional<FarEnds> far_ends(const RoadNetwork& network) {
  const auto first = node_of_largest_part(network);
  if (!first) return std::nullopt;
  const RoadPlace a = network.node_place(*first);
  const auto [b_node, a_to_b] = farthest_node(costs_from(network, a));
  if (!(a_to_b > 0)) {
    // One-way roads may lead here only.
    const auto [origin, cost] = farthest_node(costs_from(network, a, true));
    if (cost > 0) return FarEnds{network.node_place(origin), {a, false}};
    return FarEnds{a, farthest_from(network, a, false)};
  }
  const RoadPlace b = network.node_place(b_node);
  const auto [c_node, b_to_c] = farthest_node(costs_from(network, b));
  // One-way roads may leave no way back from b.
  if (b_to_c < a_to_b) return FarEnds{a, {b, false}};
  return FarEnds{b, {network.node_place(c_node), false}};
}

}  // namespace stope::planner
