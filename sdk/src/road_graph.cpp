#include "stope/payloads/road_graph.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <vector>

#include "measure_road.hpp"
#include "stope/digest.hpp"

namespace stope {
namespace {

std::int64_t centimetres(double metres) { return std::llround(metres * 100.0); }

std::uint64_t id_from(const std::vector<std::int64_t>& numbers) {
  // Kept below 2^53 so that every format that stores ids as doubles (JSON) keeps them exact; never
  // 0.
  return (digest_of(numbers).low & ((1ULL << 53) - 1)) | 1ULL;
}

void sort_nodes(RoadGraph& graph) {
  std::vector<std::uint32_t> order(graph.nodes.size());
  std::iota(order.begin(), order.end(), 0U);
  const auto key = [&](std::uint32_t i) {
    const RoadNode& node = graph.nodes[i];
    return std::tuple(node.x, node.y, node.id);
  };
  std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return key(a) < key(b); });
  std::vector<std::uint32_t> place(order.size());
  std::vector<RoadNode> nodes;
  nodes.reserve(order.size());
  for (const std::uint32_t old : order) {
    place[old] = static_cast<std::uint32_t>(nodes.size());
    nodes.push_back(graph.nodes[old]);
  }
  graph.nodes = std::move(nodes);
  for (RoadEdge& edge : graph.edges) {
    edge.from = place[edge.from];
    edge.to = place[edge.to];
  }
}

bool less(const RoadVertex& a, const RoadVertex& b) {
  return std::tie(a.x, a.y) < std::tie(b.x, b.y);
}

void direct_edges(RoadGraph& graph) {
  for (RoadEdge& edge : graph.edges) {
    const auto begin = graph.vertices.begin() + edge.first_vertex;
    const auto end = begin + edge.vertex_count;
    const bool loop = edge.from == edge.to;
    const bool backward_loop =
        loop && std::lexicographical_compare(std::make_reverse_iterator(end),
                                             std::make_reverse_iterator(begin), begin, end, less);
    if (edge.from < edge.to || (loop && !backward_loop)) continue;
    std::swap(edge.from, edge.to);
    std::reverse(begin, end);
    if (edge.direction == RoadDirection::kForward) {
      edge.direction = RoadDirection::kBackward;
    } else if (edge.direction == RoadDirection::kBackward) {
      edge.direction = RoadDirection::kForward;
    }
  }
}

void sort_edges(RoadGraph& graph) {
  std::stable_sort(graph.edges.begin(), graph.edges.end(),
                   [&](const RoadEdge& a, const RoadEdge& b) {
                     if (std::tie(a.from, a.to) != std::tie(b.from, b.to))
                       return std::tie(a.from, a.to) < std::tie(b.from, b.to);
                     const auto first = graph.polyline(a), second = graph.polyline(b);
                     return std::lexicographical_compare(first.begin(), first.end(), second.begin(),
                                                         second.end(), less);
                   });
  std::vector<RoadVertex> vertices;
  vertices.reserve(graph.vertices.size());
  for (RoadEdge& edge : graph.edges) {
    const auto line = graph.polyline(edge);
    edge.first_vertex = static_cast<std::uint32_t>(vertices.size());
    vertices.insert(vertices.end(), line.begin(), line.end());
  }
  graph.vertices = std::move(vertices);
}

void identify(RoadGraph& graph) {
  for (RoadNode& node : graph.nodes) {
    if (node.id == 0) node.id = id_from({centimetres(node.x), centimetres(node.y)});
  }
  for (RoadEdge& edge : graph.edges) {
    if (edge.id != 0) continue;
    const auto line = graph.polyline(edge);
    const RoadVertex& middle = line[line.size() / 2];
    edge.id = id_from({static_cast<std::int64_t>(graph.nodes[edge.from].id),
                       static_cast<std::int64_t>(graph.nodes[edge.to].id), centimetres(edge.length),
                       centimetres(middle.x), centimetres(middle.y)});
  }
}

}  // namespace

void canonicalize(RoadGraph& graph) {
  sort_nodes(graph);
  direct_edges(graph);
  sort_edges(graph);
  for (RoadEdge& edge : graph.edges) measure_road(graph.polyline(edge), edge);
  identify(graph);
}

}  // namespace stope
