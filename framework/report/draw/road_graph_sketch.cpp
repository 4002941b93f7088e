#include <fmt/format.h>

#include <cmath>
#include <numeric>

#include "framework/report/draw/simplify.hpp"
#include "framework/report/draw/sketches.hpp"
#include "framework/report/quantity_text.hpp"

namespace stope::report {
namespace {

// Beyond it a picture is a texture: names under the pointer would only make the page heavy.
constexpr std::size_t kTitledEdges = 3000;

bool is_sound(const RoadGraph& graph, const RoadEdge& edge) {
  return edge.from < graph.nodes.size() && edge.to < graph.nodes.size() && edge.vertex_count >= 2 &&
         edge.first_vertex <= graph.vertices.size() &&
         edge.vertex_count <= graph.vertices.size() - edge.first_vertex;
}

struct Network {
  std::vector<std::uint32_t> degree;  ///< by node
  std::size_t loops = 0;              ///< independent cycles: edges - nodes + components
  std::size_t dead_ends = 0;
  double length = 0;  ///< metres
};

Network network_of(const RoadGraph& graph) {
  Network network;
  network.degree.resize(graph.nodes.size());
  std::vector<std::size_t> parent(graph.nodes.size());
  std::iota(parent.begin(), parent.end(), std::size_t{0});
  const auto root = [&](std::size_t node) {
    while (parent[node] != node) node = parent[node] = parent[parent[node]];
    return node;
  };
  for (const RoadEdge& edge : graph.edges) {
    if (!is_sound(graph, edge)) continue;
    ++network.degree[edge.from];
    ++network.degree[edge.to];
    network.length += edge.length;
    const std::size_t a = root(edge.from), b = root(edge.to);
    // An edge within one component closes a loop; another joins two.
    if (a == b) {
      ++network.loops;
    } else {
      parent[a] = b;
    }
  }
  for (const std::uint32_t degree : network.degree) network.dead_ends += degree == 1 ? 1U : 0U;
  return network;
}

Stroke stroke_of(const RoadGraph& graph, const RoadEdge& edge, double tolerance) {
  Stroke stroke;
  stroke.style = edge.closed != 0 ? "road closed" : "road";
  if (edge.direction != RoadDirection::kBoth) stroke.style += " one-way";
  std::vector<Vector2> line;
  for (const RoadVertex& vertex : graph.polyline(edge)) line.emplace_back(vertex.x, vertex.y);
  stroke.points = simplified(std::move(line), tolerance);
  if (graph.edges.size() <= kTitledEdges)
    stroke.title = fmt::format("{}, clearance {} at least", length_text(edge.length),
                               length_text(edge.min_clearance));
  return stroke;
}

}  // namespace

Sketch sketch_of(const RoadGraph& graph) {
  Sketch sketch;
  sketch.kind = "Road graph";
  const Network network = network_of(graph);
  sketch.caption =
      fmt::format("{}, {}, {}, {}, {}", count_text(graph.nodes.size(), "node", "nodes"),
                  count_text(graph.edges.size(), "edge", "edges"), length_text(network.length),
                  count_text(network.loops, "loop", "loops"),
                  count_text(network.dead_ends, "dead end", "dead ends"));
  std::vector<Vector2> extent;
  for (const RoadVertex& vertex : graph.vertices) extent.emplace_back(vertex.x, vertex.y);
  const double tolerance = half_a_pixel(extent);
  bool closed = false;
  for (const RoadEdge& edge : graph.edges) {
    if (!is_sound(graph, edge)) continue;
    closed |= edge.closed != 0;
    sketch.strokes.push_back(stroke_of(graph, edge, tolerance));
  }
  for (std::size_t i = 0; i < graph.nodes.size(); ++i) {
    const std::uint32_t degree = network.degree[i];
    const RoadNode& node = graph.nodes[i];
    if (!std::isfinite(node.x) || !std::isfinite(node.y)) continue;
    const char* style = degree >= 3 ? "junction" : (degree == 1 ? "dead-end" : "bend");
    sketch.marks.push_back({style, {node.x, node.y}, ""});
  }
  sketch.legend = {
      {"road", "", "road"}, {"junction", "", "junction"}, {"dead-end", "", "dead end"}};
  if (closed) sketch.legend.push_back({"road closed", "", "closed"});
  return sketch;
}

}  // namespace stope::report
