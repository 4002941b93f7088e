#include "plugins/planner/best_first_search.hpp"

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

std::vector<std::uint32_t> arcs_to(const SearchGraph& graph, const SearchLabels& labels,
                                   std::uint32_t target) {
  std::vector<std::uint32_t> arcs;
  for (std::uint32_t node = target; labels.arc(node) != kNoArc; node = graph.source(arcs.back()))
    arcs.push_back(labels.arc(node));
  std::reverse(arcs.begin(), arcs.end());
  return arcs;
}

BestFirstSearch::BestFirstSearch(const SearchGraph& graph, bool through_passages) : graph_(graph) {
  labels_.resize(graph.node_count());
  if (!through_passages) return;
  passage_.resize(graph.node_count());
  for (std::uint32_t node = 0; node < graph.node_count(); ++node)
    passage_[node] = is_passage(graph, node);
}

/// Arcs whose costs are part of what lies ahead: all nodes along them are reached at once, and none
/// need ask for it.
void BestFirstSearch::push_along(std::span<const std::uint32_t> arcs, WayCost cost, WayCost ahead,
                                 std::span<const WayEnd> targets) {
  for (const std::uint32_t arc : arcs) {
    const SearchArc& step = graph_.arc(arc);
    cost += step.cost;
    ahead -= step.cost;
    if (cost >= labels_.cost(step.to)) continue;
    labels_.set(step.to, cost, arc);
    // The arc behind the last may be driven still, only dearer.
    if (arc == arcs.back() || !is_driven_through(step.to, targets))
      heap_.push({cost + ahead, ahead}, step.to);
  }
}

bool BestFirstSearch::is_driven_through(std::uint32_t node, std::span<const WayEnd> targets) const {
  return !passage_.empty() && passage_[node] &&
         std::none_of(targets.begin(), targets.end(),
                      [node](const WayEnd& target) { return target.node == node; });
}

/// From an arc's end to the next node where there is something to decide; whether there is one that
/// was not come to more cheaply.
bool BestFirstSearch::drive_through(std::uint32_t& node, WayCost& cost, std::uint32_t& arc,
                                    std::span<const WayEnd> targets, const CostChanges& changes) {
  while (arc != kNoArc && is_driven_through(node, targets)) {
    if (cost >= labels_.cost(node)) return false;
    labels_.set(node, cost, arc);
    std::uint32_t next = graph_.first_arc(node);
    if (graph_.arc(next).to == graph_.source(arc)) ++next;
    if (next == graph_.end_arc(node)) return false;  // a dead end
    const WayCost more = changes.cost(next, graph_.arc(next).cost);
    if (more == kNoWay) return false;
    cost += more;
    arc = next;
    node = graph_.arc(next).to;
  }
  return true;
}

}  // namespace stope::planner
