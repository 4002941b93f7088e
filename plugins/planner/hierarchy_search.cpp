#include "plugins/planner/hierarchy_search.hpp"

#include <algorithm>

namespace stope::planner {

HierarchySearch::HierarchySearch(const ContractionHierarchy& hierarchy) : hierarchy_(hierarchy) {
  forward_.labels.resize(hierarchy.node_count());
  backward_.labels.resize(hierarchy.node_count());
}

void HierarchySearch::start(Side& side, std::span<const WayEnd> ends) const {
  side.labels.clear();
  side.heap.clear();
  for (const WayEnd& end : ends) {
    const std::uint32_t rank = hierarchy_.rank(end.node);
    if (end.cost >= side.labels.cost(rank)) continue;
    side.labels.set(rank, end.cost, kNoArc);
    side.heap.push(end.cost, rank);
  }
}

void HierarchySearch::step(Side& side, const Side& other, const ContractionHierarchy::Half& onward,
                           const ContractionHierarchy::Half& back) {
  const auto [cost, rank] = side.heap.pop();
  if (cost > side.labels.cost(rank)) return;
  ++settled_;
  if (other.labels.known(rank) && cost + other.labels.cost(rank) < best_) {
    best_ = cost + other.labels.cost(rank);
    top_ = rank;
  }
  // A node that is reached more cheaply from above is on no cheapest way that climbs through it.
  for (const SearchArc& arc : back.of(rank))
    if (side.labels.known(arc.to) && side.labels.cost(arc.to) + arc.cost < cost) return;
  for (std::uint32_t place = onward.first[rank]; place < onward.first[rank + 1]; ++place) {
    const SearchArc& arc = onward.arcs[place];
    const WayCost further = cost + arc.cost;
    if (further >= side.labels.cost(arc.to)) continue;
    side.labels.set(arc.to, further, place);
    side.heap.push(further, arc.to);
  }
}

void HierarchySearch::climb(std::span<const WayEnd> sources, std::span<const WayEnd> targets) {
  best_ = kNoWay;
  settled_ = 0;
  start(forward_, sources);
  start(backward_, targets);
  const auto live = [this](const Side& side) {
    return !side.heap.empty() && side.heap.top().key < best_;
  };
  for (;;) {
    const bool forward = live(forward_), backward = live(backward_);
    if (!forward && !backward) return;
    if (forward && (!backward || forward_.heap.top().key <= backward_.heap.top().key)) {
      step(forward_, backward_, hierarchy_.up(), hierarchy_.down());
    } else {
      step(backward_, forward_, hierarchy_.down(), hierarchy_.up());
    }
  }
}

WayCost HierarchySearch::cost(std::span<const WayEnd> sources, std::span<const WayEnd> targets) {
  climb(sources, targets);
  return best_;
}

Way HierarchySearch::find(std::span<const WayEnd> sources, std::span<const WayEnd> targets) {
  climb(sources, targets);
  Way way;
  way.cost = best_;
  way.settled = settled_;
  if (!way.found()) return way;
  // An arc up ends where it was reached; what it comes from is found by its place.
  const auto below = [](const ContractionHierarchy::Half& half, std::uint32_t place) {
    const auto after = std::upper_bound(half.first.begin(), half.first.end(), place);
    return static_cast<std::uint32_t>(after - half.first.begin() - 1);
  };
  std::vector<std::uint32_t> climbed;
  std::uint32_t rank = top_;
  for (; forward_.labels.arc(rank) != kNoArc; rank = below(hierarchy_.up(), climbed.back()))
    climbed.push_back(forward_.labels.arc(rank));
  way.source = hierarchy_.node(rank);
  for (std::size_t i = climbed.size(); i-- > 0;) hierarchy_.unpack_up(climbed[i], way.arcs);
  for (rank = top_; backward_.labels.arc(rank) != kNoArc;) {
    const std::uint32_t place = backward_.labels.arc(rank);
    hierarchy_.unpack_down(place, way.arcs);
    rank = below(hierarchy_.down(), place);
  }
  way.target = hierarchy_.node(rank);
  return way;
}

}  // namespace stope::planner
