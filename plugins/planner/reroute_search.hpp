#pragma once

#include <optional>
#include <span>
#include <vector>

#include "plugins/planner/best_first_search.hpp"
#include "plugins/planner/contraction_hierarchy.hpp"
#include "plugins/planner/corridor.hpp"

namespace stope::planner {

/// Cheapest ways where some arcs are blocked or dearer than a contraction hierarchy was made for.
/// Keeps references to all; one query at a time.
class RerouteSearch {
 public:
  /// With the hierarchy's landmarks_by_rank() dense networks are searched faster.
  RerouteSearch(const SearchGraph& graph, const ContractionHierarchy& hierarchy,
                const Landmarks* landmarks = nullptr);
  /// A cheapest way from one of the sources to one of the targets.
  Way find(std::span<const WayEnd> sources, std::span<const WayEnd> targets,
           const CostChanges& changes);

 private:
  class OldWays;
  Way search(std::span<const WayEnd> sources, std::span<const WayEnd> targets,
             const CostChanges& changes);
  bool is_worth(std::uint32_t rank, const ContractionHierarchy::Half& half) const {
    return !corridor_ || corridor_->is_worth(rank, half);
  }
  void descend_from(std::span<const WayEnd> targets);
  void descend_chains(std::span<const WayEnd> targets);
  WayCost ahead(std::uint32_t rank);
  void take_all_ahead(std::uint32_t rank);
  void take_ahead(std::uint32_t rank);

  const ContractionHierarchy& hierarchy_;
  BestFirstSearch search_;
  const Landmarks* landmarks_;
  WayCost detour_ = 0;                // what an arc costs in the mean
  std::optional<Corridor> corridor_;  // of the query
  SearchLabels down_, ahead_;
  SearchHeap<WayCost> down_heap_;
  std::vector<std::uint32_t> chain_, climb_;
};

}  // namespace stope::planner
