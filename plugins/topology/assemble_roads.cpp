// Problem: bring a graph into canonical order, where nearly all of its roads were measured before.
// Idea: what canonicalize() says of a road depends on its vertices alone, so it is asked once about
// a graph of that road. Then nodes and roads are only sorted, by the same keys, and copied.
// Cost: see the header.
#include "plugins/topology/assemble_roads.hpp"

#include <algorithm>
#include <numeric>
#include <tuple>

namespace stope::topology {
namespace {

std::size_t at(std::int32_t place) { return static_cast<std::size_t>(place); }

bool less(const RoadVertex& a, const RoadVertex& b) {
  return std::tie(a.x, a.y) < std::tie(b.x, b.y);
}

bool same_place(const RoadNode& a, const RoadNode& b) { return a.x == b.x && a.y == b.y; }

/// Nodes in canonical order; `rank` tells where each came to be.
std::vector<RoadNode> sorted(const std::vector<RoadNode>& nodes, std::vector<std::uint32_t>& rank) {
  std::vector<std::uint32_t> order(nodes.size());
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return std::tie(nodes[a].x, nodes[a].y) < std::tie(nodes[b].x, nodes[b].y);
  });
  std::vector<RoadNode> result;
  result.reserve(nodes.size());
  for (const std::uint32_t node : order) {
    rank[node] = static_cast<std::uint32_t>(result.size());
    result.push_back(nodes[node]);
  }
  return result;
}

/// For nodes in one place, whose order says which way a road goes.
RoadGraph canonical(const std::vector<RoadNode>& nodes, const std::vector<SettledRoad>& roads) {
  RoadGraph graph;
  graph.nodes = nodes;
  for (const SettledRoad& settled : roads) {
    RoadEdge edge;
    edge.width = settled.road->edge.width;
    std::vector<RoadVertex> line = settled.road->vertices;
    const RoadNode& from = nodes[at(settled.from)];
    if (line.front().x != from.x || line.front().y != from.y)
      std::reverse(line.begin(), line.end());
    edge.from = static_cast<std::uint32_t>(settled.from);
    edge.to = static_cast<std::uint32_t>(settled.to);
    edge.first_vertex = static_cast<std::uint32_t>(graph.vertices.size());
    edge.vertex_count = static_cast<std::uint32_t>(line.size());
    graph.vertices.insert(graph.vertices.end(), line.begin(), line.end());
    graph.edges.push_back(edge);
  }
  canonicalize(graph);
  return graph;
}

}  // namespace

FinishedRoad settle_road(std::vector<RoadVertex> vertices, double width, bool ring) {
  RoadGraph graph;
  const auto add_node = [&](const RoadVertex& place) {
    graph.nodes.push_back({0, place.x, place.y, place.z});
  };
  add_node(vertices.front());
  if (!ring) add_node(vertices.back());
  RoadEdge edge;
  edge.to = ring ? 0 : 1;
  edge.vertex_count = static_cast<std::uint32_t>(vertices.size());
  edge.width = width;
  graph.vertices = std::move(vertices);
  graph.edges.push_back(edge);
  canonicalize(graph);
  return {std::move(graph.vertices),
          graph.edges.front(),
          {graph.nodes.front().id, graph.nodes.back().id}};
}

RoadGraph assemble_roads(const std::vector<RoadNode>& nodes,
                         const std::vector<SettledRoad>& roads) {
  std::vector<std::uint32_t> rank(nodes.size());
  RoadGraph graph;
  graph.nodes = sorted(nodes, rank);
  if (std::adjacent_find(graph.nodes.begin(), graph.nodes.end(), same_place) != graph.nodes.end())
    return canonical(nodes, roads);

  std::size_t vertices = 0;
  std::vector<std::pair<RoadEdge, const FinishedRoad*>> edges;
  edges.reserve(roads.size());
  for (const auto& [from, to, road] : roads) {
    const std::uint32_t a = rank[at(from)], b = rank[at(to)];
    edges.emplace_back(road->edge, road);
    RoadEdge& edge = edges.back().first;
    edge.from = std::min(a, b), edge.to = std::max(a, b);
    graph.nodes[edge.from].id = road->nodes[0];
    graph.nodes[edge.to].id = road->nodes[1];
    vertices += road->vertices.size();
  }
  std::stable_sort(edges.begin(), edges.end(), [](const auto& a, const auto& b) {
    if (std::tie(a.first.from, a.first.to) != std::tie(b.first.from, b.first.to))
      return std::tie(a.first.from, a.first.to) < std::tie(b.first.from, b.first.to);
    const auto &first = a.second->vertices, &second = b.second->vertices;
    return std::lexicographical_compare(first.begin(), first.end(), second.begin(), second.end(),
                                        less);
  });
  graph.edges.reserve(edges.size());
  graph.vertices.reserve(vertices);
  for (auto& [edge, road] : edges) {
    edge.first_vertex = static_cast<std::uint32_t>(graph.vertices.size());
    graph.vertices.insert(graph.vertices.end(), road->vertices.begin(), road->vertices.end());
    graph.edges.push_back(edge);
  }
  // Of nodes that no road ends at.
  RoadGraph lone;
  for (const RoadNode& node : graph.nodes)
    if (node.id == 0) lone.nodes.push_back(node);
  canonicalize(lone);
  auto next = lone.nodes.cbegin();
  for (RoadNode& node : graph.nodes)
    if (node.id == 0) node = *next++;
  return graph;
}

}  // namespace stope::topology
