#include "plugins/metric/check_graph.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "stope/error.hpp"

namespace stope::metric {
namespace {

// Beyond this, lengths lose the centimetre; no map reaches as far.
constexpr double kFarthest = 1e9;

void check_place(double x, double y, const std::string& what, const std::string& port) {
  if (std::abs(x) <= kFarthest && std::abs(y) <= kFarthest) return;  // false for NaN
  throw Error(
      fmt::format("{} of the graph at '{}' lies at ({}, {}); coordinates must be metres "
                  "in the map frame, at most 1e9: look at the stage that made the graph",
                  what, port, x, y));
}

}  // namespace

void check_graph(const RoadGraph& graph, const std::string& port) {
  for (std::size_t i = 0; i < graph.nodes.size(); ++i)
    check_place(graph.nodes[i].x, graph.nodes[i].y, fmt::format("node {}", i), port);
  for (std::size_t i = 0; i < graph.vertices.size(); ++i)
    check_place(graph.vertices[i].x, graph.vertices[i].y, fmt::format("vertex {}", i), port);
  for (std::size_t i = 0; i < graph.edges.size(); ++i) {
    const RoadEdge& edge = graph.edges[i];
    if (std::max(edge.from, edge.to) >= graph.nodes.size())
      throw Error(fmt::format("edge {} of the graph at '{}' joins node {}, but there are {} nodes",
                              i, port, std::max(edge.from, edge.to), graph.nodes.size()));
    const std::uint64_t end = std::uint64_t{edge.first_vertex} + edge.vertex_count;
    if (edge.vertex_count < 2 || end > graph.vertices.size())
      throw Error(fmt::format(
          "edge {} of the graph at '{}' has the vertices {} to {} of {}; a road has at least two",
          i, port, edge.first_vertex, end, graph.vertices.size()));
  }
}

void check_truth(const RoadGraph& truth) {
  check_graph(truth, "truth");
  const bool some = std::any_of(truth.edges.begin(), truth.edges.end(), [&](const RoadEdge& edge) {
    const auto line = truth.polyline(edge);
    return std::any_of(line.begin(), line.end(), [&](const RoadVertex& vertex) {
      return vertex.x != line.front().x || vertex.y != line.front().y;
    });
  });
  if (!some)
    throw Error(
        "the true graph at 'truth' has no roads, so nothing can be measured against it: wire the "
        "truth of the same map, such as truth_roads of source/synthetic_pit");
}

}  // namespace stope::metric
