// Problem: a road was blocked a second ago; the hierarchy made of the old costs does not know it.
// Idea: costs only rise, so the old cost from a node to the goal is a lower bound of the new one,
// and a hierarchy gives it exactly: one search climbs from the goal, and any other node's bound is
// the best over its arcs up, taken when it is first asked for and kept (Strasser and Zeitz, "A Fast
// and Tight Heuristic for A* in Road Networks", 2021). A* with that bound (Hart, Nilsson and
// Raphael 1968) runs straight along the old way and looks around only where it is blocked. Nodes
// with two neighbours are driven through without asking for a bound. Cost: the climb from the goal,
// and for each node touched a climb through those not yet known.
#include "plugins/planner/reroute_search.hpp"

#include <algorithm>

#include "plugins/planner/hierarchy_search.hpp"

namespace stope::planner {
RerouteSearch::RerouteSearch(const SearchGraph& graph, const ContractionHierarchy& hierarchy)
    : hierarchy_(hierarchy), search_(graph, true) {
  for (SearchLabels* labels : {&down_, &ahead_}) labels->resize(graph.node_count());
}

void RerouteSearch::descend_from(std::span<const WayEnd> targets) {
  ahead_.clear();
  if (hierarchy_.has_chains()) {
    list_chains(hierarchy_, targets, down_, chain_);
    for (const std::uint32_t rank : chain_) {
      const WayCost cost = down_.cost(rank);
      if (cost == kNoWay) continue;
      for (const SearchArc& arc : hierarchy_.down().of(rank))
        if (cost + arc.cost < down_.cost(arc.to)) down_.set(arc.to, cost + arc.cost, kNoArc);
    }
    return;
  }
  down_.clear();
  down_heap_.clear();
  const auto reach = [this](std::uint32_t rank, WayCost cost) {
    if (cost >= down_.cost(rank)) return;
    down_.set(rank, cost, kNoArc);
    down_heap_.push(cost, rank);
  };
  for (const WayEnd& target : targets) reach(hierarchy_.rank(target.node), target.cost);
  while (!down_heap_.empty()) {
    const auto [cost, rank] = down_heap_.pop();
    if (cost > down_.cost(rank)) continue;
    for (const SearchArc& arc : hierarchy_.down().of(rank)) reach(arc.to, cost + arc.cost);
  }
}

/// The unchanged cost from a node to the nearest target; kNoWay if there is no way.
WayCost RerouteSearch::ahead(std::uint32_t rank) {
  if (ahead_.known(rank)) return ahead_.cost(rank);
  climb_.clear();
  if (hierarchy_.has_chains()) {
    for (std::uint32_t here = rank; here != kNoArc && !ahead_.known(here);
         here = hierarchy_.next(here))
      climb_.push_back(here);
    for (; !climb_.empty(); climb_.pop_back()) take_ahead(climb_.back());
    return ahead_.cost(rank);
  }
  // Nodes wait on a stack until all that lie above them are known.
  climb_.push_back(rank);
  while (!climb_.empty()) {
    const std::uint32_t here = climb_.back();
    const std::size_t waiting = climb_.size();
    if (!ahead_.known(here)) {
      for (const SearchArc& arc : hierarchy_.up().of(here))
        if (!ahead_.known(arc.to)) climb_.push_back(arc.to);
    }
    if (climb_.size() > waiting) continue;
    if (!ahead_.known(here)) take_ahead(here);
    climb_.pop_back();
  }
  return ahead_.cost(rank);
}

/// All above the node are known.
void RerouteSearch::take_ahead(std::uint32_t rank) {
  WayCost best = down_.cost(rank);
  for (const SearchArc& arc : hierarchy_.up().of(rank)) {
    const WayCost beyond = ahead_.cost(arc.to);
    if (beyond != kNoWay) best = std::min(best, beyond + arc.cost);
  }
  ahead_.set(rank, best, kNoArc);
}

Way RerouteSearch::find(std::span<const WayEnd> sources, std::span<const WayEnd> targets,
                        const CostChanges& changes) {
  descend_from(targets);
  return search_.find(sources, targets, changes,
                      [this](std::uint32_t node) { return ahead(hierarchy_.rank(node)); });
}

}  // namespace stope::planner
