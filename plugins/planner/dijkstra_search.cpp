#include "plugins/planner/dijkstra_search.hpp"

namespace stope::planner {

std::vector<WayCost> DijkstraSearch::costs(std::uint32_t node, bool against,
                                           const CostChanges& changes) {
  std::vector<WayCost> costs(graph_.node_count(), kNoWay);
  heap_.clear();
  const auto reach = [&](std::uint32_t there, WayCost cost) {
    if (cost >= costs[there]) return;
    costs[there] = cost;
    heap_.push(cost, there);
  };
  const auto drive = [&](std::uint32_t arc, std::uint32_t there, WayCost cost) {
    const WayCost more = changes.cost(arc, graph_.arc(arc).cost);
    if (more != kNoWay) reach(there, cost + more);
  };
  reach(node, 0);
  while (!heap_.empty()) {
    const auto [cost, here] = heap_.pop();
    if (cost > costs[here]) continue;
    if (against) {
      for (const SearchGraph::Into& into : graph_.into(here)) drive(into.arc, into.from, cost);
    } else {
      for (std::uint32_t arc = graph_.first_arc(here); arc < graph_.end_arc(here); ++arc)
        drive(arc, graph_.arc(arc).to, cost);
    }
  }
  return costs;
}

}  // namespace stope::planner
