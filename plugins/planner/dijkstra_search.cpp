#include "plugins/planner/dijkstra_search.hpp"

#include <algorithm>

namespace stope::planner {

std::vector<std::uint32_t> arcs_to(const SearchGraph& graph, const SearchLabels& labels,
                                   std::uint32_t target) {
  std::vector<std::uint32_t> arcs;
  for (std::uint32_t node = target; labels.arc(node) != kNoArc; node = graph.source(arcs.back()))
    arcs.push_back(labels.arc(node));
  std::reverse(arcs.begin(), arcs.end());
  return arcs;
}

std::vector<WayCost> DijkstraSearch::costs(std::uint32_t node, bool against) {
  std::vector<WayCost> costs(graph_.node_count(), kNoWay);
  heap_.clear();
  const auto reach = [&](std::uint32_t there, WayCost cost) {
    if (cost >= costs[there]) return;
    costs[there] = cost;
    heap_.push(cost, there);
  };
  reach(node, 0);
  while (!heap_.empty()) {
    const auto [cost, here] = heap_.pop();
    if (cost > costs[here]) continue;
    if (against) {
      for (const SearchGraph::Into& into : graph_.into(here))
        reach(into.from, cost + graph_.arc(into.arc).cost);
    } else {
      for (std::uint32_t arc = graph_.first_arc(here); arc < graph_.end_arc(here); ++arc)
        reach(graph_.arc(arc).to, cost + graph_.arc(arc).cost);
    }
  }
  return costs;
}

}  // namespace stope::planner
