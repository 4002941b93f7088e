#include "tests/plugins/export/export_samples.hpp"

#include <cmath>
#include <stdexcept>

namespace stope::exports {

RoadGraph sample_roads() {
  RoadGraph graph;
  const double nan = std::nan("");
  graph.nodes = {{11, 0, 0, 1.5}, {22, 30.25, 0, nan}, {33, 30.25, 40, nan}};
  const auto add = [&](std::uint32_t from, std::uint32_t to, std::vector<RoadVertex> line) {
    RoadEdge edge;
    edge.id = 9007199254740000ULL + graph.edges.size();
    edge.from = from, edge.to = to;
    edge.first_vertex = static_cast<std::uint32_t>(graph.vertices.size());
    edge.vertex_count = static_cast<std::uint32_t>(line.size());
    edge.width = 12.5;
    graph.vertices.insert(graph.vertices.end(), line.begin(), line.end());
    graph.edges.push_back(edge);
    return graph.edges.size() - 1;
  };
  add(0, 1, {{0, 0, 1.5, 4}, {30.25, 0, nan, 6}});
  const auto curved =
      add(0, 2, {{0, 0, 1.5, 4}, {10, 20, nan, 5}, {20, 34, nan, 5}, {30.25, 40, nan, 3}});
  graph.edges[curved].direction = RoadDirection::kForward;
  graph.edges[curved].speed_limit = 8.25;
  const auto closed = add(1, 2, {{30.25, 0, nan, 6}, {30.25, 40, nan, 3}});
  graph.edges[closed].closed = 1;
  canonicalize(graph);
  return graph;
}

std::string text_of(const Artefact& artefact, const std::string& extension) {
  for (const ArtefactFile& file : artefact.files) {
    if (file.extension == extension) return {file.bytes.begin(), file.bytes.end()};
  }
  throw std::runtime_error("no file ." + extension);
}

}  // namespace stope::exports
