// Problem: cheapest ways in a large graph where some arcs are blocked or dearer today.
// Idea: A* from both ends at once. Each end has a lower bound of its own (LandmarkBound); half
// their difference is a potential that both searches agree on (Ikeda et al. 1994), so that they may
// stop as soon as the sum of their smallest keys says that no cheaper way is left. Twice the costs
// keep everything in whole numbers. Cost: O((V + E) log V) at worst; with 16 landmarks some percent
// of the graph between the ends.
#include "plugins/planner/landmark_search.hpp"

#include <algorithm>

#include "plugins/planner/best_first_search.hpp"

namespace stope::planner {

LandmarkSearch::LandmarkSearch(const SearchGraph& graph, const Landmarks& landmarks)
    : graph_(graph), landmarks_(landmarks) {
  forward_.labels.resize(graph.node_count());
  backward_.labels.resize(graph.node_count());
}

Way LandmarkSearch::find(std::span<const WayEnd> sources, std::span<const WayEnd> targets,
                         const CostChanges& changes) {
  const LandmarkBound ahead(landmarks_, true, targets, sources);
  const LandmarkBound behind(landmarks_, false, sources, targets);
  const auto key = [&](bool forward, WayCost cost, std::uint32_t node) {
    const std::int64_t potential = ahead(node) - behind(node);
    return 2 * static_cast<std::int64_t>(cost) + (forward ? potential : -potential);
  };
  Way way;
  std::uint32_t meeting = 0;
  const auto reach = [&](bool forward, std::uint32_t node, WayCost cost, std::uint32_t arc) {
    Side& side = forward ? forward_ : backward_;
    if (cost >= side.labels.cost(node)) return;
    side.labels.set(node, cost, arc);
    side.heap.push(key(forward, cost, node), node);
    const WayCost rest = (forward ? backward_ : forward_).labels.cost(node);
    if (rest != kNoWay && cost + rest < way.cost) {
      way.cost = cost + rest;
      meeting = node;
    }
  };
  for (Side* side : {&forward_, &backward_}) {
    side->labels.clear();
    side->heap.clear();
  }
  for (const WayEnd& source : sources) reach(true, source.node, source.cost, kNoArc);
  for (const WayEnd& target : targets) reach(false, target.node, target.cost, kNoArc);
  while (!forward_.heap.empty() && !backward_.heap.empty()) {
    const std::int64_t sum = forward_.heap.top().key + backward_.heap.top().key;
    if (way.found() && sum >= 2 * static_cast<std::int64_t>(way.cost)) break;
    const bool forward = forward_.heap.top().key <= backward_.heap.top().key;
    Side& side = forward ? forward_ : backward_;
    const auto [top, node] = side.heap.pop();
    const WayCost cost = side.labels.cost(node);
    if (top > key(forward, cost, node)) continue;
    ++way.settled;
    if (forward) {
      for (std::uint32_t arc = graph_.first_arc(node); arc < graph_.end_arc(node); ++arc) {
        const WayCost more = changes.cost(arc, graph_.arc(arc).cost);
        if (more != kNoWay) reach(true, graph_.arc(arc).to, cost + more, arc);
      }
    } else {
      for (const SearchGraph::Into& into : graph_.into(node)) {
        const WayCost more = changes.cost(into.arc, graph_.arc(into.arc).cost);
        if (more != kNoWay) reach(false, into.from, cost + more, into.arc);
      }
    }
  }
  if (!way.found()) return way;
  way.arcs = arcs_to(graph_, forward_.labels, meeting);
  way.source = way.arcs.empty() ? meeting : graph_.source(way.arcs.front());
  way.target = meeting;
  for (; backward_.labels.arc(way.target) != kNoArc; way.target = graph_.arc(way.arcs.back()).to)
    way.arcs.push_back(backward_.labels.arc(way.target));
  return way;
}

}  // namespace stope::planner
