#pragma once

#include <span>
#include <vector>

#include "plugins/planner/route_query.hpp"
#include "plugins/planner/search_labels.hpp"

namespace stope::planner {

/// Dijkstra's search (1959), without any preparation: the measure of the others. Keeps a reference
/// to the graph; one query at a time.
class DijkstraSearch {
 public:
  explicit DijkstraSearch(const SearchGraph& graph) : graph_(graph) {
    labels_.resize(graph.node_count());
  }
  /// A cheapest way from one of the sources to one of the targets. O((V + E) log V).
  Way find(std::span<const WayEnd> sources, std::span<const WayEnd> targets,
           const CostChanges& changes = {}) {
    return find_by_bound(sources, targets, changes, [](std::uint32_t) { return WayCost{0}; });
  }
  /// The same with A* (Hart, Nilsson and Raphael 1968): `bound` gives what the way from a node to
  /// the nearest target costs at least.
  template <class Bound>
  Way find_by_bound(std::span<const WayEnd> sources, std::span<const WayEnd> targets,
                    const CostChanges& changes, const Bound& bound);
  /// What each node costs to reach from a node, or with `against` to come from to it; kNoWay where
  /// there is no way.
  std::vector<WayCost> costs(std::uint32_t node, bool against = false);

 private:
  const SearchGraph& graph_;
  SearchLabels labels_;
  SearchHeap<WayCost> heap_;
};

/// The arcs that lead to `target`, as a search's labels tell them, from the source on.
std::vector<std::uint32_t> arcs_to(const SearchGraph& graph, const SearchLabels& labels,
                                   std::uint32_t target);

template <class Bound>
Way DijkstraSearch::find_by_bound(std::span<const WayEnd> sources, std::span<const WayEnd> targets,
                                  const CostChanges& changes, const Bound& bound) {
  Way way;
  labels_.clear();
  heap_.clear();
  const auto reach = [&](std::uint32_t node, WayCost cost, std::uint32_t arc) {
    if (cost >= labels_.cost(node)) return;
    labels_.set(node, cost, arc);
    heap_.push(cost + bound(node), node);
  };
  for (const WayEnd& source : sources) reach(source.node, source.cost, kNoArc);
  while (!heap_.empty() && heap_.top().key < way.cost) {
    const auto [key, node] = heap_.pop();
    const WayCost cost = labels_.cost(node);
    if (key > cost + bound(node)) continue;  // stale
    ++way.settled;
    for (const WayEnd& target : targets) {
      if (target.node != node || target.cost >= way.cost - cost) continue;
      way.cost = cost + target.cost;
      way.target = node;
    }
    for (std::uint32_t arc = graph_.first_arc(node); arc < graph_.end_arc(node); ++arc) {
      const SearchArc& step = graph_.arc(arc);
      const WayCost more = changes.cost(arc, step.cost);
      if (more != kNoWay) reach(step.to, cost + more, arc);
    }
  }
  if (!way.found()) return way;
  way.arcs = arcs_to(graph_, labels_, way.target);
  way.source = way.arcs.empty() ? way.target : graph_.source(way.arcs.front());
  return way;
}

}  // namespace stope::planner
