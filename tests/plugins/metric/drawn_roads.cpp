#include "tests/plugins/metric/drawn_roads.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace stope::metric {
namespace {

std::uint32_t node_at(RoadGraph& graph, const Vector2& place) {
  for (std::uint32_t i = 0; i < graph.nodes.size(); ++i)
    if (graph.nodes[i].x == place.x() && graph.nodes[i].y == place.y()) return i;
  graph.nodes.push_back({0, place.x(), place.y(), 0});
  return static_cast<std::uint32_t>(graph.nodes.size() - 1);
}

}  // namespace

RoadGraph draw_roads(const std::vector<std::vector<Vector2>>& lines) {
  RoadGraph graph;
  for (const auto& line : lines) {
    RoadEdge edge;
    edge.from = node_at(graph, line.front());
    edge.to = node_at(graph, line.back());
    edge.first_vertex = static_cast<std::uint32_t>(graph.vertices.size());
    edge.vertex_count = static_cast<std::uint32_t>(line.size());
    for (const Vector2& point : line) graph.vertices.push_back({point.x(), point.y(), 0, 5});
    graph.edges.push_back(edge);
  }
  if (!lines.empty()) canonicalize(graph);
  return graph;
}

RoadGraph random_roads(Random& random, int nodes, int roads, double size) {
  const auto point = [&] { return Vector2(random.uniform(0, size), random.uniform(0, size)); };
  std::vector<Vector2> places;
  for (int i = 0; i < nodes; ++i) places.push_back(point());
  std::vector<std::vector<Vector2>> lines;
  for (int i = 0; i < roads; ++i) {
    const std::size_t from = random.below(places.size()), to = random.below(places.size());
    std::vector<Vector2> line{places[from]};
    for (std::uint64_t k = random.below(3) + (from == to ? 2 : 0); k > 0; --k)
      line.push_back(point());
    line.push_back(places[to]);
    lines.push_back(line);
  }
  return draw_roads(lines);
}

double value_of(const Measures& measures, const std::string& name) {
  const auto found = std::find(measures.names.begin(), measures.names.end(), name);
  if (found != measures.names.end())
    return measures.values[static_cast<std::size_t>(found - measures.names.begin())];
  ADD_FAILURE() << "there is no figure " << name;
  return std::numeric_limits<double>::quiet_NaN();
}

}  // namespace stope::metric
