#include "plugins/export/route_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "stope/error.hpp"

namespace stope::exports {
namespace {

void check_unique(std::vector<std::uint64_t> ids, const char* what) {
  std::sort(ids.begin(), ids.end());
  const auto twin = std::adjacent_find(ids.begin(), ids.end());
  if (twin != ids.end()) {
    throw Error(fmt::format(
        "two {} of the road graph have the id {}, so that they could not be told apart on reading: "
        "leave ids 0 and call canonicalize(), which makes unique ones",
        what, *twin));
  }
}

void check_place(double x, double y, double z, const char* what, std::uint64_t id) {
  if (!std::isfinite(x) || !std::isfinite(y) || std::isinf(z)) {
    throw Error(fmt::format("the {} {} of the road graph lies at ({}, {}, {}), which is no place",
                            what, id, x, y, z));
  }
}

}  // namespace

void check_writable(const RoadGraph& graph) {
  std::vector<std::uint64_t> ids;
  for (const RoadNode& node : graph.nodes) {
    check_place(node.x, node.y, node.z, "node", node.id);
    ids.push_back(node.id);
  }
  check_unique(std::move(ids), "nodes");
  ids.clear();
  for (const RoadEdge& edge : graph.edges) {
    ids.push_back(edge.id);
    if (edge.from >= graph.nodes.size() || edge.to >= graph.nodes.size())
      throw Error(
          fmt::format("the road {} joins nodes that the road graph does not have", edge.id));
    if (edge.vertex_count < 2 || edge.first_vertex > graph.vertices.size() ||
        edge.vertex_count > graph.vertices.size() - edge.first_vertex) {
      throw Error(fmt::format("the road {} has no line of at least two vertices", edge.id));
    }
    for (const RoadVertex& vertex : graph.polyline(edge))
      check_place(vertex.x, vertex.y, vertex.z, "road", edge.id);
  }
  check_unique(std::move(ids), "roads");
}

}  // namespace stope::exports
