#pragma once

#include <span>
#include <vector>

#include "plugins/planner/contraction_hierarchy.hpp"
#include "plugins/planner/corridor.hpp"
#include "plugins/planner/route_query.hpp"
#include "plugins/planner/search_labels.hpp"

namespace stope::planner {

/// Lists, in order, the ranks that a climb from any of `ends` can come to, of a hierarchy that has
/// chains, and writes the labels of these: kNoWay, at the ends their costs.
void list_chains(const ContractionHierarchy& hierarchy, std::span<const WayEnd> ends,
                 SearchLabels& labels, std::vector<std::uint32_t>& chain);

/// Cheapest ways in a graph whose costs have not changed: two searches that climb a contraction
/// hierarchy, from the sources and from the targets, until they meet. Keeps references; one query
/// at a time.
class HierarchySearch {
 public:
  /// With the hierarchy's landmarks_by_rank() dense networks are searched faster.
  explicit HierarchySearch(const ContractionHierarchy& hierarchy,
                           const Landmarks* landmarks = nullptr);
  /// A cheapest way from one of the sources to one of the targets.
  Way find(std::span<const WayEnd> sources, std::span<const WayEnd> targets);
  /// What it costs, without the way itself.
  WayCost cost(std::span<const WayEnd> sources, std::span<const WayEnd> targets);

 private:
  struct Side {
    SearchLabels labels;
    SearchHeap<WayCost> heap;
    std::vector<std::uint32_t> chain;
  };
  void start(Side& side, std::span<const WayEnd> ends) const;
  void step(Side& side, const Side& other, const ContractionHierarchy::Half& onward,
            const ContractionHierarchy::Half& back);
  void climb(std::span<const WayEnd> sources, std::span<const WayEnd> targets);
  void climb_in_order_of_cost(std::span<const WayEnd> sources, std::span<const WayEnd> targets);
  void climb_chains(std::span<const WayEnd> sources, std::span<const WayEnd> targets,
                    const Corridor* corridor);

  const ContractionHierarchy& hierarchy_;
  const Landmarks* landmarks_;
  Side forward_, backward_;
  // Where the best way so far turns from climbing to descending.
  WayCost best_ = kNoWay;
  std::uint32_t top_ = 0, settled_ = 0;
};

}  // namespace stope::planner
