#include "plugins/source/synthetic_pit/network_graph.hpp"

#include <algorithm>
#include <utility>

namespace stope::source {
namespace {

struct Cut {
  std::size_t point;
  std::size_t node;
  bool operator<(const Cut& other) const { return point < other.point; }
};

NetworkGraph::Edge run(const Street& street, const Cut& from, const Cut& to) {
  NetworkGraph::Edge edge;
  edge.from = from.node;
  edge.to = to.node;
  edge.width = street.width;
  const std::size_t n = street.points.size();
  const std::size_t last = to.point > from.point ? to.point : to.point + n;
  for (std::size_t i = from.point; i <= last; ++i) {
    edge.points.push_back(street.points[i % n]);
    edge.elevation.push_back(street.elevation[i % n]);
  }
  return edge;
}

}  // namespace

NetworkGraph cut_at_junctions(const StreetNetwork& network) {
  NetworkGraph graph;
  std::vector<std::vector<Cut>> cuts(network.streets.size());
  for (const Attachment& tie : network.attachments) {
    std::vector<Cut>& through = cuts[tie.through];
    auto cut = std::find_if(through.begin(), through.end(),
                            [&](const Cut& c) { return c.point == tie.through_point; });
    if (cut == through.end()) {
      const Street& street = network.streets[tie.through];
      graph.nodes.push_back(
          {street.points[tie.through_point], street.elevation[tie.through_point], std::nullopt});
      through.push_back({tie.through_point, graph.nodes.size() - 1});
      cut = through.end() - 1;
    }
    const std::size_t node = cut->node;
    const std::size_t last = network.streets[tie.branch].points.size() - 1;
    cuts[tie.branch].push_back({tie.at_end ? last : 0, node});
  }
  for (std::size_t i = 0; i < network.dead_ends.size(); ++i) {
    const DeadEnd& end = network.dead_ends[i];
    graph.nodes.push_back({network.centre(end), network.elevation(end), i});
    const std::size_t last = network.streets[end.street].points.size() - 1;
    cuts[end.street].push_back({end.at_end ? last : 0, graph.nodes.size() - 1});
  }
  for (std::size_t i = 0; i < network.streets.size(); ++i) {
    const Street& street = network.streets[i];
    std::sort(cuts[i].begin(), cuts[i].end());
    if (street.closed && cuts[i].empty()) {
      graph.nodes.push_back({street.points[0], street.elevation[0], std::nullopt});
      cuts[i].push_back({0, graph.nodes.size() - 1});
    }
    for (std::size_t k = 0; k + 1 < cuts[i].size(); ++k)
      graph.edges.push_back(run(street, cuts[i][k], cuts[i][k + 1]));
    if (street.closed) graph.edges.push_back(run(street, cuts[i].back(), cuts[i].front()));
  }
  return graph;
}

}  // namespace stope::source
