// Problem: a road was blocked a second ago; the hierarchy made of the old costs does not know it.
// Idea: costs only rise, so the old cost from a node to the goal is a lower bound of the new one,
// and a hierarchy gives it exactly: one search climbs from the goal, and any other node's bound is
// the best over its arcs up, taken when it is first asked for and kept (Strasser and Zeitz, "A Fast
// and Tight Heuristic for A* in Road Networks", 2021). A* with that bound (Hart, Nilsson and
// Raphael 1968) runs straight along the old way and looks around only where it is blocked. Nodes
// with two neighbours are driven through without asking for a bound. Cost: the climb from the goal,
// and for each node touched a climb through those not yet known.
#include "plugins/planner/reroute_search.hpp"

#include <algorithm>

#include "plugins/planner/dijkstra_search.hpp"

namespace stope::planner {
namespace {

/// Whether there is but one way on from a node, wherever it was come to from, save back.
bool is_passage(const SearchGraph& graph, std::uint32_t node) {
  const std::uint32_t first = graph.first_arc(node), count = graph.end_arc(node) - first;
  if (count == 1) return graph.arc(first).to != node;
  if (count != 2) return false;
  const std::uint32_t a = graph.arc(first).to, b = graph.arc(first + 1).to;
  const auto into = graph.into(node);
  return a != b && a != node && b != node &&
         std::all_of(into.begin(), into.end(),
                     [&](const SearchGraph::Into& arc) { return arc.from == a || arc.from == b; });
}

}  // namespace

RerouteSearch::RerouteSearch(const SearchGraph& graph, const ContractionHierarchy& hierarchy)
    : graph_(graph), hierarchy_(hierarchy), passage_(graph.node_count()) {
  for (SearchLabels* labels : {&labels_, &down_, &ahead_}) labels->resize(graph.node_count());
  for (std::uint32_t node = 0; node < graph.node_count(); ++node)
    passage_[node] = is_passage(graph, node);
}

void RerouteSearch::descend_from(std::span<const WayEnd> targets) {
  down_.clear();
  down_heap_.clear();
  ahead_.clear();
  const auto reach = [this](std::uint32_t rank, WayCost cost) {
    if (cost >= down_.cost(rank)) return;
    down_.set(rank, cost, kNoArc);
    down_heap_.push(cost, rank);
  };
  for (const WayEnd& target : targets) reach(hierarchy_.rank(target.node), target.cost);
  while (!down_heap_.empty()) {
    const auto [cost, rank] = down_heap_.pop();
    if (cost > down_.cost(rank)) continue;
    for (const SearchArc& arc : hierarchy_.down().of(rank)) reach(arc.to, cost + arc.cost);
  }
}

/// The unchanged cost from a node to the nearest target; kNoWay if there is no way.
WayCost RerouteSearch::ahead(std::uint32_t rank) {
  if (ahead_.known(rank)) return ahead_.cost(rank);
  // Nodes wait on a stack until all that lie above them are known.
  climb_.assign(1, rank);
  while (!climb_.empty()) {
    const std::uint32_t here = climb_.back();
    if (ahead_.known(here)) {
      climb_.pop_back();
      continue;
    }
    WayCost best = down_.cost(here);
    bool waits = false;
    for (const SearchArc& arc : hierarchy_.up().of(here)) {
      if (!ahead_.known(arc.to)) {
        climb_.push_back(arc.to);
        waits = true;
      } else if (ahead_.cost(arc.to) != kNoWay) {
        best = std::min(best, ahead_.cost(arc.to) + arc.cost);
      }
    }
    if (waits) continue;
    ahead_.set(here, best, kNoArc);
    climb_.pop_back();
  }
  return ahead_.cost(rank);
}

Way RerouteSearch::find(std::span<const WayEnd> sources, std::span<const WayEnd> targets,
                        const CostChanges& changes) {
  Way way;
  labels_.clear();
  heap_.clear();
  descend_from(targets);
  const auto ends_at = [&](std::uint32_t node) {
    return std::any_of(targets.begin(), targets.end(),
                       [node](const WayEnd& target) { return target.node == node; });
  };
  const auto reach = [&](std::uint32_t node, WayCost cost, std::uint32_t arc) {
    while (arc != kNoArc && passage_[node] && !ends_at(node)) {
      if (cost >= labels_.cost(node)) return;
      labels_.set(node, cost, arc);
      std::uint32_t next = graph_.first_arc(node);
      if (graph_.arc(next).to == graph_.source(arc)) ++next;
      if (next == graph_.end_arc(node)) return;  // a dead end
      const WayCost more = changes.cost(next, graph_.arc(next).cost);
      if (more == kNoWay) return;
      cost += more;
      arc = next;
      node = graph_.arc(next).to;
    }
    if (cost >= labels_.cost(node)) return;
    const WayCost rest = ahead(hierarchy_.rank(node));
    if (rest == kNoWay) return;
    labels_.set(node, cost, arc);
    heap_.push({cost + rest, rest}, node);
  };
  for (const WayEnd& source : sources) reach(source.node, source.cost, kNoArc);
  while (!heap_.empty() && heap_.top().key.whole < way.cost) {
    const auto [key, node] = heap_.pop();
    const WayCost cost = labels_.cost(node);
    if (key.whole - key.ahead > cost) continue;
    ++way.settled;
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
  way.source = way.arcs.empty() ? way.target : graph_.source(way.arcs.front());
  return way;
}

}  // namespace stope::planner
