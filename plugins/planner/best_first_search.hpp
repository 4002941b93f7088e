#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "plugins/planner/route_query.hpp"
#include "plugins/planner/search_labels.hpp"

namespace stope::planner {

/// The arcs that lead to `target`, as a search's labels tell them, from the source on.
std::vector<std::uint32_t> arcs_to(const SearchGraph& graph, const SearchLabels& labels,
                                   std::uint32_t target);

/// For searches that know no way on.
struct NoKnownWay {
  static constexpr bool wanted(WayCost) { return false; }
  static constexpr bool follow(std::uint32_t, WayCost, std::vector<std::uint32_t>&) {
    return false;
  }
};

/// A* (Hart, Nilsson and Raphael 1968): the loop that all searches from one end share. Keeps a
/// reference to the graph; one query at a time.
class BestFirstSearch {
 public:
  /// With `through_passages` nodes that have two neighbours, so that there is nothing to decide,
  /// are driven through without asking what lies ahead. O(V + E) then.
  explicit BestFirstSearch(const SearchGraph& graph, bool through_passages = false);
  const SearchGraph& graph() const { return graph_; }

  /// A cheapest way from one of the sources to one of the targets. `ahead` gives what the way from
  /// a node to the nearest target costs at least, kNoWay if there is none. If
  /// `known.wanted(ahead)`, `known.follow(node, ahead, arcs)` lists arcs of a way on whose costs
  /// make up `ahead`: the whole way, or else, with false, as far as it is free. A way that
  /// costs more than `most` need not be found nor be the cheapest, and `ahead` may be anything too
  /// high on it. O((V + E) log V).
  template <class Ahead, class Known = NoKnownWay>
  Way find(std::span<const WayEnd> sources, std::span<const WayEnd> targets,
           const CostChanges& changes, const Ahead& ahead, Known&& known = {},
           WayCost most = kNoWay);

 private:
  struct Key {
    WayCost whole, ahead;  // of two ways as cheap the one that is further along
    bool operator<(const Key& other) const {
      return whole != other.whole ? whole < other.whole : ahead < other.ahead;
    }
    bool operator!=(const Key& other) const { return whole != other.whole || ahead != other.ahead; }
  };

  void push_along(std::span<const std::uint32_t> arcs, WayCost cost, WayCost ahead,
                  std::span<const WayEnd> targets);
  bool is_driven_through(std::uint32_t node, std::span<const WayEnd> targets) const;
  bool drive_through(std::uint32_t& node, WayCost& cost, std::uint32_t& arc,
                     std::span<const WayEnd> targets, const CostChanges& changes);

  const SearchGraph& graph_;
  std::vector<bool> passage_;  // of each node; empty: none
  SearchLabels labels_;
  SearchHeap<Key> heap_;
  std::vector<std::uint32_t> known_arcs_;
};

template <class Ahead, class Known>
Way BestFirstSearch::find(std::span<const WayEnd> sources, std::span<const WayEnd> targets,
                          const CostChanges& changes, const Ahead& ahead, Known&& known,
                          WayCost most) {
  Way way;
  labels_.clear();
  heap_.clear();
  known_arcs_.clear();
  const auto reach = [&](std::uint32_t node, WayCost cost, std::uint32_t arc) {
    if (!drive_through(node, cost, arc, targets, changes)) return;
    if (cost >= labels_.cost(node)) return;
    const WayCost rest = ahead(node);
    if (rest == kNoWay) return;
    labels_.set(node, cost, arc);
    heap_.push({cost + rest, rest}, node);
  };
  for (const WayEnd& source : sources) reach(source.node, source.cost, kNoArc);
  while (!heap_.empty() && heap_.top().key.whole < way.cost && heap_.top().key.whole <= most) {
    const auto [key, node] = heap_.pop();
    const WayCost cost = labels_.cost(node);
    if (key.whole - key.ahead > cost) continue;  // stale
    ++way.settled;
    if (known.wanted(key.ahead)) {
      if (known.follow(node, key.ahead, known_arcs_)) {
        way.cost = key.whole;
        way.target = node;
        break;
      }
      push_along(known_arcs_, cost, key.ahead, targets);
      known_arcs_.clear();
    }
    for (const WayEnd& target : targets) {
      if (target.node != node || target.cost >= way.cost - cost) continue;
      way.cost = cost + target.cost;
      way.target = node;
    }
    for (std::uint32_t arc = graph_.first_arc(node); arc < graph_.end_arc(node); ++arc) {
      const SearchArc& step = graph_.arc(arc);
      const WayCost more = changes.cost(arc, step.cost);
      if (more != kNoWay) reach(step.to, cost + more, arc);
    }
  }
  if (!way.found()) return way;
  way.arcs = arcs_to(graph_, labels_, way.target);
  way.arcs.insert(way.arcs.end(), known_arcs_.begin(), known_arcs_.end());
  way.source = way.arcs.empty() ? way.target : graph_.source(way.arcs.front());
  if (!known_arcs_.empty()) way.target = graph_.arc(known_arcs_.back()).to;
  return way;
}

}  // namespace stope::planner
