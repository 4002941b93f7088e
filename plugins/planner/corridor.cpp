// Problem: in a grid a climb comes to thousands of nodes with hundreds of arcs each, most of them
// far from any way one would take. Idea: landmarks bound what a way over a node costs (Goldberg and
// Harrelson 2005). If that is more than some way from source to target costs, no cheapest way leads
// over the node, and its arcs need not be looked at. That way's cost is guessed first, a little
// above the landmarks' bound (which is half a percent short in the median on a grid of random
// costs): what is then found is right if it costs no more than the guess, else the guess was too
// low. Cost: 8 loads a node instead of up to some hundred; in one query of eight the second guess,
// too.
#include "plugins/planner/corridor.hpp"

#include <algorithm>

#include "plugins/planner/hierarchy_sweep.hpp"

namespace stope::planner {
namespace {

constexpr std::uint32_t kLandmarks = 16;

std::vector<WayEnd> by_rank(const ContractionHierarchy& hierarchy, std::span<const WayEnd> ends) {
  std::vector<WayEnd> ranks;
  for (const WayEnd& end : ends) ranks.push_back({hierarchy.rank(end.node), end.cost});
  return ranks;
}

}  // namespace

std::optional<Landmarks> landmarks_by_rank(const ContractionHierarchy& hierarchy,
                                           const std::function<void()>& pause) {
  if (!hierarchy.has_chains()) return std::nullopt;
  return Landmarks(
      hierarchy.node_count(), kLandmarks,
      [&](std::uint32_t rank, bool against) { return sweep_costs(hierarchy, rank, against); },
      pause);
}

Corridor::Corridor(const ContractionHierarchy& hierarchy, const Landmarks& landmarks,
                   std::span<const WayEnd> sources, std::span<const WayEnd> targets)
    : ahead_(landmarks, true, by_rank(hierarchy, targets), by_rank(hierarchy, sources)),
      behind_(landmarks, false, by_rank(hierarchy, sources), by_rank(hierarchy, targets)) {
  for (const WayEnd& source : sources)
    least_ =
        std::min(least_, source.cost + static_cast<WayCost>(ahead_(hierarchy.rank(source.node))));
}

}  // namespace stope::planner
