#include "plugins/planner/hierarchy_search.hpp"

#include <algorithm>

namespace stope::planner {

void list_chains(const ContractionHierarchy& hierarchy, std::span<const WayEnd> ends,
                 SearchLabels& labels, std::vector<std::uint32_t>& chain) {
  labels.clear();
  chain.clear();
  for (const WayEnd& end : ends) {
    const auto before = static_cast<std::ptrdiff_t>(chain.size());
    for (std::uint32_t rank = hierarchy.rank(end.node); rank != kNoArc && !labels.known(rank);
         rank = hierarchy.next(rank)) {
      labels.set(rank, kNoWay, kNoArc);
      chain.push_back(rank);
    }
    std::inplace_merge(chain.begin(), chain.begin() + before, chain.end());
  }
  for (const WayEnd& end : ends) {
    const std::uint32_t rank = hierarchy.rank(end.node);
    if (end.cost < labels.cost(rank)) labels.set(rank, end.cost, kNoArc);
  }
}

HierarchySearch::HierarchySearch(const ContractionHierarchy& hierarchy, const Landmarks* landmarks)
    : hierarchy_(hierarchy), landmarks_(landmarks) {
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
  settled_ = 0;
  if (!hierarchy_.has_chains()) return climb_in_order_of_cost(sources, targets);
  if (landmarks_ == nullptr) return climb_chains(sources, targets, nullptr);
  Corridor corridor(hierarchy_, *landmarks_, sources, targets);
  corridor.widen_until([&] {
    climb_chains(sources, targets, &corridor);
    return best_ <= corridor.most();
  });
}

void HierarchySearch::climb_in_order_of_cost(std::span<const WayEnd> sources,
                                             std::span<const WayEnd> targets) {
  best_ = kNoWay;
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

/// Where all nodes that can be come to stand in a chain, it is gone along once, without a heap: all
/// nodes below have been looked at when a node's turn comes.
void HierarchySearch::climb_chains(std::span<const WayEnd> sources, std::span<const WayEnd> targets,
                                   const Corridor* corridor) {
  best_ = kNoWay;
  const auto list = [&](Side& side, std::span<const WayEnd> ends,
                        const ContractionHierarchy::Half& half) {
    list_chains(hierarchy_, ends, side.labels, side.chain);
    if (corridor == nullptr) return;
    std::erase_if(side.chain, [&](std::uint32_t rank) { return !corridor->is_worth(rank, half); });
  };
  list(forward_, sources, hierarchy_.up());
  list(backward_, targets, hierarchy_.down());
  const auto relax = [this](Side& side, std::uint32_t rank,
                            const ContractionHierarchy::Half& half) {
    const WayCost cost = side.labels.cost(rank);
    if (cost >= best_) return;
    ++settled_;
    const std::uint32_t end = half.first[rank + 1];
    for (std::uint32_t place = half.first[rank]; place < end; ++place) {
      const SearchArc arc = half.arcs[place];
      side.labels.lower_known(arc.to, cost + arc.cost, place);
    }
  };
  const auto &up = forward_.chain, &down = backward_.chain;
  for (std::size_t i = 0, k = 0; i < up.size() || k < down.size();) {
    const std::uint32_t from = i < up.size() ? up[i] : kNoArc;
    const std::uint32_t to = k < down.size() ? down[k] : kNoArc;
    if (from == to) {
      const WayCost ahead = backward_.labels.cost(to), behind = forward_.labels.cost(from);
      if (ahead != kNoWay && behind != kNoWay && behind + ahead < best_) {
        best_ = behind + ahead;
        top_ = from;
      }
    }
    if (from <= to) relax(forward_, up[i++], hierarchy_.up());
    if (to <= from) relax(backward_, down[k++], hierarchy_.down());
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
  std::vector<std::uint32_t> climbed;
  std::uint32_t rank = top_;
  for (; forward_.labels.arc(rank) != kNoArc; rank = hierarchy_.up().lower_end(climbed.back()))
    climbed.push_back(forward_.labels.arc(rank));
  way.source = hierarchy_.node(rank);
  for (std::size_t i = climbed.size(); i-- > 0;) hierarchy_.unpack_up(climbed[i], way.arcs);
  for (rank = top_; backward_.labels.arc(rank) != kNoArc;) {
    const std::uint32_t place = backward_.labels.arc(rank);
    hierarchy_.unpack_down(place, way.arcs);
    rank = hierarchy_.down().lower_end(place);
  }
  way.target = hierarchy_.node(rank);
  return way;
}

}  // namespace stope::planner
