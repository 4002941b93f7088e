#pragma once

#include <span>

#include "plugins/planner/landmarks.hpp"
#include "plugins/planner/route_query.hpp"
#include "plugins/planner/search_labels.hpp"

namespace stope::planner {

/// Cheapest ways by A* from both ends with lower bounds taken from landmarks; arcs may be blocked
/// or dearer than the landmarks were measured with. Keeps references to both; one query at a time.
class LandmarkSearch {
 public:
  LandmarkSearch(const SearchGraph& graph, const Landmarks& landmarks);
  /// A cheapest way from one of the sources to one of the targets.
  Way find(std::span<const WayEnd> sources, std::span<const WayEnd> targets,
           const CostChanges& changes = {});

 private:
  struct Side {
    SearchLabels labels;
    SearchHeap<std::int64_t> heap;
  };

  const SearchGraph& graph_;
  const Landmarks& landmarks_;
  Side forward_, backward_;
};

}  // namespace stope::planner
