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

#include "plugins/planner/node_contraction.hpp"

namespace stope::planner {
namespace {

constexpr std::size_t kFew = 12;

struct Turn {
  std::uint64_t importance;
  std::uint32_t node;
  bool operator<(const Turn& other) const {  // for std::push_heap: the least important on top
    return importance != other.importance ? importance > other.importance : node > other.node;
  }
};

}  // namespace

ContractionHierarchy::ContractionHierarchy(const SearchGraph& graph,
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
  while (!turns.empty()) {
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
