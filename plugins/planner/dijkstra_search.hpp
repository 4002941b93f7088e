#pragma once

#include <span>
#include <vector>

#include "plugins/planner/best_first_search.hpp"

namespace stope::planner {

/// Dijkstra's search (1959), without any preparation: the measure of the others. Keeps a reference
/// to the graph; one query at a time.
class DijkstraSearch {
 public:
  explicit DijkstraSearch(const SearchGraph& graph) : graph_(graph), search_(graph) {}
  /// A cheapest way from one of the sources to one of the targets. O((V + E) log V).
  Way find(std::span<const WayEnd> sources, std::span<const WayEnd> targets,
           const CostChanges& changes = {}) {
    return search_.find(sources, targets, changes, [](std::uint32_t) { return WayCost{0}; });
  }
  /// What each node costs to reach from a node, or with `against` to come from to it; kNoWay where
  /// there is no way.
  std::vector<WayCost> costs(std::uint32_t node, bool against = false,
                             const CostChanges& changes = {});

 private:
  const SearchGraph& graph_;
  BestFirstSearch search_;
  SearchHeap<WayCost> heap_;
};

}  // namespace stope::planner
