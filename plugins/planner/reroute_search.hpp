#pragma once

#include <span>
#include <vector>

#include "plugins/planner/contraction_hierarchy.hpp"
#include "plugins/planner/route_query.hpp"
#include "plugins/planner/search_labels.hpp"

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
  struct Key {
    WayCost whole, ahead;  // of two ways as cheap the one that is further along
    bool operator<(const Key& other) const {
      return whole != other.whole ? whole < other.whole : ahead < other.ahead;
    }
    bool operator!=(const Key& other) const { return whole != other.whole || ahead != other.ahead; }
  };
  void descend_from(std::span<const WayEnd> targets);
  WayCost ahead(std::uint32_t rank);

  const SearchGraph& graph_;
  const ContractionHierarchy& hierarchy_;
  SearchLabels labels_, down_, ahead_;
  SearchHeap<Key> heap_;
  SearchHeap<WayCost> down_heap_;
  std::vector<std::uint32_t> climb_;
  std::vector<bool> passage_;  // nodes with two neighbours: nothing to decide
};

}  // namespace stope::planner
