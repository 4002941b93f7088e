#include "tests/plugins/planner/test_roads.hpp"

namespace stope::planner {

std::size_t add_road(RoadGraph& graph, std::uint32_t from, std::uint32_t to,
                     const std::vector<Vector2>& between, double clearance) {
  RoadEdge edge;
  edge.from = from, edge.to = to;
  edge.first_vertex = static_cast<std::uint32_t>(graph.vertices.size());
  edge.vertex_count = static_cast<std::uint32_t>(between.size() + 2);
  edge.id = 1000 + graph.edges.size();
  edge.min_clearance = clearance;
  const auto add = [&](double x, double y) { graph.vertices.push_back({x, y, 0, clearance}); };
  add(graph.nodes[from].x, graph.nodes[from].y);
  for (const Vector2& point : between) add(point.x(), point.y());
  add(graph.nodes[to].x, graph.nodes[to].y);
  graph.edges.push_back(edge);
  return graph.edges.size() - 1;
}

RoadGraph random_roads(Random& random, std::uint32_t nodes, std::uint32_t roads) {
  RoadGraph graph;
  for (std::uint32_t i = 0; i < nodes; ++i)
    graph.nodes.push_back({i + 1, random.uniform(0, 100), random.uniform(0, 100), 0});
  for (std::uint32_t i = 0; i < roads; ++i) {
    const auto from = static_cast<std::uint32_t>(random.below(nodes));
    const auto to = static_cast<std::uint32_t>(random.below(nodes));
    std::vector<Vector2> between;
    for (std::uint64_t k = random.below(3) + (from == to ? 2 : 0); k > 0; --k)
      between.emplace_back(random.uniform(0, 100), random.uniform(0, 100));
    RoadEdge& edge = graph.edges[add_road(graph, from, to, between, random.uniform(1, 12))];
    edge.direction = static_cast<RoadDirection>(random.below(5) < 3 ? 0 : 1 + random.below(2));
    edge.closed = random.below(10) == 0 ? 1 : 0;
  }
  return graph;
}

}  // namespace stope::planner
