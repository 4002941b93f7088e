#pragma once

#include <span>
#include <vector>

#include "plugins/planner/best_first_search.hpp"
#include "plugins/planner/contraction_hierarchy.hpp"

namespace stope::planner {

/// Cheapest ways where some arcs are blocked or dearer than a contraction hierarchy was made for.
/// Keeps references to both; one query at a time.
class RerouteSearch {
 public:
  RerouteSearch(const SearchGraph& graph, const ContractionHierarchy& hierarchy);
  /// A cheapest way from one of the sources to one of the targets.
  Way find(std::span<const WayEnd> sources, std::span<const WayEnd> targets,
           const CostChanges& changes);

 private:
  class OldWays;
  void descend_from(std::span<const WayEnd> targets);
  WayCost ahead(std::uint32_t rank);
  void take_all_ahead(std::uint32_t rank);
  void take_ahead(std::uint32_t rank);

  const ContractionHierarchy& hierarchy_;
  BestFirstSearch search_;
  SearchLabels down_, ahead_;
  SearchHeap<WayCost> down_heap_;
  std::vector<std::uint32_t> chain_, climb_;
};

}  // namespace stope::planner
