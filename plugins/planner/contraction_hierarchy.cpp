// Problem: find cheapest ways in a graph of a million nodes in well under a millisecond, as long as
// its costs stay as they are.
// Idea: contraction hierarchies (Geisberger, Sanders, Schultes and Delling 2008). Nodes are taken
// out one by one, the least important first; where a cheapest way ran through the node, a shortcut
// between its neighbours takes its place, unless a witness (another way as cheap) makes it
// needless. Importance is the node's level plus the shortcuts it would add and the arcs they stand
// for, each per arc it would remove; it is taken again whenever a neighbour goes, and when its turn
// comes. Cost: four small searches a node and turn, each cut off after a fixed number of nodes: a
// missed witness costs a needless shortcut, never a wrong answer. About O(n log n) on road
// networks.
#include "plugins/planner/contraction_hierarchy.hpp"

#include <algorithm>
#include <limits>
#include <tuple>

#include "plugins/planner/core_contraction.hpp"
#include "plugins/planner/node_contraction.hpp"

namespace stope::planner {
namespace {

constexpr std::size_t kFew = 12;     // neighbours, of which the importance is taken at once
constexpr std::uint64_t kDense = 6;  // links a node, from which on the rest is a core

struct Turn {
  std::uint64_t importance;
  std::uint32_t node;
  bool operator<(const Turn& other) const {  // for std::push_heap: the least important on top
    return importance != other.importance ? importance > other.importance : node > other.node;
  }
};

/// Orders the nodes that have no rank yet and takes them out, all at once.
void take_core(const NodeContraction& contraction, std::span<const NodePlace> places,
               std::vector<std::uint32_t>& rank_of, std::vector<std::uint32_t>& node_of,
               ContractionHierarchy::Half& up, ContractionHierarchy::Half& down,
               const std::function<void()>& pause) {
  constexpr std::uint32_t kGone = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> local(rank_of.size(), 0), nodes;
  for (const std::uint32_t node : node_of) local[node] = kGone;
  for (std::uint32_t node = 0; node < local.size(); ++node) {
    if (local[node] == kGone) continue;
    local[node] = static_cast<std::uint32_t>(nodes.size());
    nodes.push_back(node);
  }
  NeighbourLists neighbours;
  std::vector<NodePlace> where;
  neighbours.first.push_back(0);
  for (const std::uint32_t node : nodes) {
    const auto begin = static_cast<std::ptrdiff_t>(neighbours.nodes.size());
    for (const auto* links : {&contraction.links_from(node), &contraction.links_to(node)})
      for (const auto& link : *links) neighbours.nodes.push_back(local[link.other]);
    std::sort(neighbours.nodes.begin() + begin, neighbours.nodes.end());
    neighbours.nodes.erase(std::unique(neighbours.nodes.begin() + begin, neighbours.nodes.end()),
                           neighbours.nodes.end());
    neighbours.first.push_back(static_cast<std::uint32_t>(neighbours.nodes.size()));
    where.push_back(places[node]);
  }
  std::vector<std::uint32_t> order = dissection_order(neighbours, where);
  for (std::uint32_t& node : order) node = nodes[node];
  for (std::uint32_t i = 0; i < order.size(); ++i) local[order[i]] = i;
  std::vector<CoreLink> links;
  for (std::uint32_t i = 0; i < order.size(); ++i) {
    for (const auto& link : contraction.links_from(order[i]))
      links.push_back({i, local[link.other], link.cost, link.parts});
  }
  std::sort(links.begin(), links.end(), [](const CoreLink& a, const CoreLink& b) {
    return std::tie(a.from, a.to) < std::tie(b.from, b.to);
  });
  contract_core(order, links, up, down, pause);
  for (const std::uint32_t node : order) {
    rank_of[node] = static_cast<std::uint32_t>(node_of.size());
    node_of.push_back(node);
  }
}

}  // namespace

ContractionHierarchy::ContractionHierarchy(const SearchGraph& graph,
                                           std::span<const NodePlace> places,
                                           const std::function<void()>& pause)
    : rank_of_(graph.node_count()) {
  NodeContraction contraction(graph, up_, down_);
  std::vector<std::uint64_t> importance(graph.node_count());
  std::vector<Turn> turns;
  turns.reserve(graph.node_count());
  for (std::uint32_t node = 0; node < graph.node_count(); ++node) {
    if (node % 4096 == 0) pause();
    turns.push_back({importance[node] = contraction.importance(node), node});
  }
  std::make_heap(turns.begin(), turns.end());
  std::vector<std::uint32_t> neighbours;
  while (node_of_.size() < graph.node_count()) {
    const std::uint64_t left = graph.node_count() - node_of_.size();
    if (!places.empty() && contraction.link_count() > kDense * left) {
      take_core(contraction, places, rank_of_, node_of_, up_, down_, pause);
      break;
    }
    std::pop_heap(turns.begin(), turns.end());
    const Turn turn = turns.back();
    turns.pop_back();
    if (importance[turn.node] != turn.importance) continue;  // stale, or contracted
    if (node_of_.size() % 1024 == 0) pause();
    const std::uint64_t checked = contraction.importance(turn.node);
    if (checked > turn.importance && !turns.empty() && Turn{checked, turn.node} < turns.front()) {
      importance[turn.node] = checked;
      turns.push_back({checked, turn.node});
      std::push_heap(turns.begin(), turns.end());
      continue;
    }
    rank_of_[turn.node] = static_cast<std::uint32_t>(node_of_.size());
    node_of_.push_back(turn.node);
    importance[turn.node] = std::numeric_limits<std::uint64_t>::max();
    contraction.contract(turn.node, neighbours);
    // Where there are many, they are checked when their turn comes.
    if (neighbours.size() > kFew) continue;
    for (const std::uint32_t node : neighbours) {
      const std::uint64_t now = contraction.importance(node);
      if (now == importance[node]) continue;
      importance[node] = now;
      turns.push_back({now, node});
      std::push_heap(turns.begin(), turns.end());
    }
  }
  for (Half* half : {&up_, &down_}) {
    if (half->first.size() == node_of_.size())
      half->first.push_back(static_cast<std::uint32_t>(half->arcs.size()));
    for (SearchArc& arc : half->arcs) arc.to = rank_of_[arc.to];
  }
}

void ContractionHierarchy::unpack_up(std::uint32_t place, std::vector<std::uint32_t>& arcs) const {
  unpack(up_.parts[place], arcs);
}

void ContractionHierarchy::unpack_down(std::uint32_t place,
                                       std::vector<std::uint32_t>& arcs) const {
  unpack(down_.parts[place], arcs);
}

void ContractionHierarchy::unpack(const Parts& parts, std::vector<std::uint32_t>& arcs) const {
  // As deep as the hierarchy is high, some hundred levels: a stack of its own keeps it safe.
  std::vector<Parts> stack{parts};
  while (!stack.empty()) {
    const Parts top = stack.back();
    stack.pop_back();
    if (top.down == kNoArc) {
      arcs.push_back(top.up);
    } else {
      stack.push_back(up_.parts[top.up]);
      stack.push_back(down_.parts[top.down]);
    }
  }
}

}  // namespace stope::planner
