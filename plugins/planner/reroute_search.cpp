// Problem: a road was blocked a second ago; the hierarchy made of the old costs does not know it.
// Idea: costs only rise, so the old cost from a node to the goal is a lower bound of the new one,
// and a hierarchy gives it exactly: one search climbs from the goal, and any other node's bound is
// the best over its arcs up, taken when it is first asked for and kept (Strasser and Zeitz, "A Fast
// and Tight Heuristic for A* in Road Networks", 2021). A* with that bound (Hart, Nilsson and
// Raphael 1968) looks around only where the old way, which it follows at once, is blocked. Nodes
// with two neighbours are driven through without asking for a bound. In dense networks bounds are
// taken within a Corridor alone, the narrower one of all but the longest detours once the old cost
// is known; A* needs no other, as long as the way it finds costs no more than the corridor allows.
// Cost: the climb from the goal, and for each node touched a climb through those not yet known.
#include "plugins/planner/reroute_search.hpp"

#include <algorithm>

#include "plugins/planner/hierarchy_search.hpp"

namespace stope::planner {
namespace {

constexpr WayCost kUnreachable = kNoWay / 2;  // stays so when costs are added
constexpr std::size_t kSoon = 3;  // nodes ahead of which the arcs are asked of the memory

}  // namespace

RerouteSearch::RerouteSearch(const SearchGraph& graph, const ContractionHierarchy& hierarchy,
                             const Landmarks* landmarks)
    : hierarchy_(hierarchy), search_(graph, true), landmarks_(landmarks) {
  for (SearchLabels* labels : {&down_, &ahead_}) labels->resize(graph.node_count());
  for (std::uint32_t arc = 0; arc < graph.arc_count(); ++arc) detour_ += graph.arc(arc).cost;
  detour_ /= std::max(1U, graph.arc_count());
}

void RerouteSearch::descend_from(std::span<const WayEnd> targets) {
  ahead_.clear();
  if (hierarchy_.has_chains()) return descend_chains(targets);
  const ContractionHierarchy::Half& half = hierarchy_.down();
  down_.clear();
  down_heap_.clear();
  const auto reach = [this](std::uint32_t rank, WayCost cost, std::uint32_t place) {
    if (cost >= down_.cost(rank)) return;
    down_.set(rank, cost, place);
    down_heap_.push(cost, rank);
  };
  for (const WayEnd& target : targets) reach(hierarchy_.rank(target.node), target.cost, kNoArc);
  while (!down_heap_.empty()) {
    const auto [cost, rank] = down_heap_.pop();
    if (cost > down_.cost(rank)) continue;
    for (std::uint32_t place = half.first[rank]; place < half.first[rank + 1]; ++place)
      reach(half.arcs[place].to, cost + half.arcs[place].cost, place);
  }
}

void RerouteSearch::descend_chains(std::span<const WayEnd> targets) {
  const ContractionHierarchy::Half& half = hierarchy_.down();
  list_chains(hierarchy_, targets, down_, chain_);
  std::erase_if(chain_, [&](std::uint32_t rank) { return !is_worth(rank, half); });
  for (std::size_t i = 0; i < chain_.size(); ++i) {
    if (i + kSoon < chain_.size()) half.fetch(chain_[i + kSoon]);
    const WayCost cost = down_.cost(chain_[i]);
    if (cost == kNoWay) continue;
    for (std::uint32_t place = half.first[chain_[i]]; place < half.first[chain_[i] + 1]; ++place)
      down_.lower_known(half.arcs[place].to, cost + half.arcs[place].cost, place);
  }
}

/// The unchanged cost from a node to the nearest target; kNoWay if there is no way.
WayCost RerouteSearch::ahead(std::uint32_t rank) {
  if (!ahead_.known(rank)) take_all_ahead(rank);
  const WayCost cost = ahead_.known_cost(rank);
  return cost < kUnreachable ? cost : kNoWay;
}

void RerouteSearch::take_all_ahead(std::uint32_t rank) {
  climb_.clear();
  if (hierarchy_.has_chains()) {
    for (std::uint32_t here = rank; here != kNoArc && !ahead_.known(here);
         here = hierarchy_.next(here)) {
      if (is_worth(here, hierarchy_.up()))
        climb_.push_back(here);
      else
        ahead_.set(here, kUnreachable, kNoArc);
    }
    for (; !climb_.empty(); climb_.pop_back()) {
      if (climb_.size() > kSoon) hierarchy_.up().fetch(climb_[climb_.size() - 1 - kSoon]);
      take_ahead(climb_.back());
    }
    return;
  }
  // Nodes wait on a stack until all that lie above them are known.
  climb_.push_back(rank);
  while (!climb_.empty()) {
    const std::uint32_t here = climb_.back();
    const std::size_t waiting = climb_.size();
    if (!ahead_.known(here)) {
      for (const SearchArc& arc : hierarchy_.up().of(here))
        if (!ahead_.known(arc.to)) climb_.push_back(arc.to);
    }
    if (climb_.size() > waiting) continue;
    if (!ahead_.known(here)) take_ahead(here);
    climb_.pop_back();
  }
}

/// All above the node are known.
void RerouteSearch::take_ahead(std::uint32_t rank) {
  const ContractionHierarchy::Half& half = hierarchy_.up();
  WayCost best = std::min(down_.cost(rank), kUnreachable);
  std::uint32_t by = kNoArc;
  for (std::uint32_t place = half.first[rank]; place < half.first[rank + 1]; ++place) {
    const WayCost cost = ahead_.known_cost(half.arcs[place].to) + half.arcs[place].cost;
    if (cost >= best) continue;
    best = cost;
    by = place;
  }
  ahead_.set(rank, best, by);
}

/// Ways as they were before anything changed. Followed from where the search begins, and then from
/// where it has come nearer to the goal than what was in the way of the last one: so never more
/// often than there are changes, and never from where it came by following one.
class RerouteSearch::OldWays {
 public:
  OldWays(const RerouteSearch& search, const CostChanges& changes)
      : search_(search), changes_(changes) {}

  bool wanted(WayCost ahead) const { return ahead < past_; }

  bool follow(std::uint32_t node, WayCost ahead, std::vector<std::uint32_t>& arcs) {
    const ContractionHierarchy& hierarchy = search_.hierarchy_;
    std::uint32_t rank = hierarchy.rank(node);
    for (;;) {
      pieces_.clear();
      const std::uint32_t up = search_.ahead_.arc(rank);
      if (up == kNoArc) break;
      hierarchy.unpack_up(up, pieces_);
      rank = hierarchy.up().arcs[up].to;
      if (!append(arcs, ahead)) return false;
    }
    while (search_.down_.arc(rank) != kNoArc) {
      pieces_.clear();
      const std::uint32_t down = search_.down_.arc(rank);
      hierarchy.unpack_down(down, pieces_);
      rank = hierarchy.down().lower_end(down);
      if (!append(arcs, ahead)) return false;
    }
    return true;
  }

 private:
  bool append(std::vector<std::uint32_t>& arcs, WayCost& ahead) {
    for (const std::uint32_t arc : pieces_) {
      const std::uint32_t cost = search_.search_.graph().arc(arc).cost;
      if (changes_.cost(arc, cost) != cost) {
        past_ = ahead;
        return false;
      }
      arcs.push_back(arc);
      ahead -= cost;
    }
    return true;
  }

  const RerouteSearch& search_;
  const CostChanges& changes_;
  WayCost past_ = kNoWay;  // what was ahead where the last way was not free
  std::vector<std::uint32_t> pieces_;
};

/// A cheapest way, if it costs no more than the corridor allows.
Way RerouteSearch::search(std::span<const WayEnd> sources, std::span<const WayEnd> targets,
                          const CostChanges& changes) {
  descend_from(targets);
  WayCost most = corridor_ ? corridor_->most() : kNoWay;
  if (most != kNoWay) {
    WayCost old = kNoWay;
    for (const WayEnd& source : sources) {
      const WayCost rest = ahead(hierarchy_.rank(source.node));
      if (rest != kNoWay) old = std::min(old, source.cost + rest);
    }
    if (old > most) return {};
    // Most detours are short.
    most = std::min(most, old + old / 512 + detour_);
    corridor_->narrow(most);
  }
  return search_.find(
      sources, targets, changes,
      [this](std::uint32_t node) { return ahead(hierarchy_.rank(node)); }, OldWays(*this, changes),
      most);
}

Way RerouteSearch::find(std::span<const WayEnd> sources, std::span<const WayEnd> targets,
                        const CostChanges& changes) {
  if (landmarks_ == nullptr) return search(sources, targets, changes);
  corridor_.emplace(hierarchy_, *landmarks_, sources, targets);
  Way way;
  corridor_->widen_until([&] {
    way = search(sources, targets, changes);
    return way.cost <= corridor_->most();
  });
  return way;
}

}  // namespace stope::planner
