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

#include "plugins/planner/cell_contraction.hpp"
#include "plugins/planner/node_contraction.hpp"
#include "plugins/planner/rest_network.hpp"
#include "plugins/planner/shortcut_parts.hpp"

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

}  // namespace

/// Orders the nodes that have no rank yet and takes them out, all at once.
void ContractionHierarchy::take_cells(const NodeContraction& contraction, const RestNetwork& rest,
                                      const std::function<void()>& pause) {
  const Dissection dissection = dissect(rest.neighbours, rest.places, pause);
  std::vector<std::uint32_t> place_of(rest.nodes.size());
  for (std::uint32_t i = 0; i < place_of.size(); ++i) place_of[dissection.order[i]] = i;
  std::vector<CellLink> links;
  for (std::uint32_t i = 0; i < place_of.size(); ++i) {
    const auto begin = static_cast<std::ptrdiff_t>(links.size());
    for (const auto& link : contraction.links_from(rest.nodes[dissection.order[i]]))
      links.push_back({i, place_of[rest.number_of[link.other]], link.cost, link.parts});
    std::sort(links.begin() + begin, links.end(),
              [](const CellLink& a, const CellLink& b) { return a.to < b.to; });
  }
  const CellBorders borders = cell_borders(dissection, links);
  const KeptHalves kept = contract_cells(dissection, borders, links, pause);
  const auto first_up = static_cast<std::uint32_t>(up_.arcs.size());
  const auto first_down = static_cast<std::uint32_t>(down_.arcs.size());
  const ShortcutParts parts = shortcut_parts(kept, links, first_up, first_down);
  const auto node_at = [&](std::uint32_t place) { return rest.nodes[dissection.order[place]]; };
  const auto append = [&](const KeptArcs& arcs, const auto& parts_of, std::uint32_t first,
                          Half& half) {
    for (std::size_t i = 0; i < place_of.size(); ++i) half.first.push_back(first + arcs.first[i]);
    for (const SearchArc& arc : arcs.arcs) half.arcs.push_back({node_at(arc.to), arc.cost});
    half.parts.insert(half.parts.end(), parts_of.begin(), parts_of.end());
  };
  append(kept.up, parts.up, first_up, up_);
  append(kept.down, parts.down, first_down, down_);
  if (node_of_.empty()) {
    for (std::uint32_t cell = 0; cell < dissection.cells.size(); ++cell) {
      const auto border = borders.of(cell);
      for (std::uint32_t i = dissection.cells[cell].own + 1; i < dissection.cells[cell].end; ++i)
        next_.push_back(i);
      if (dissection.cells[cell].own < dissection.cells[cell].end)
        next_.push_back(border.empty() ? kNoArc : border.front());
    }
  }
  for (std::uint32_t i = 0; i < place_of.size(); ++i) {
    rank_of_[node_at(i)] = static_cast<std::uint32_t>(node_of_.size());
    node_of_.push_back(node_at(i));
  }
}

ContractionHierarchy::ContractionHierarchy(const SearchGraph& graph,
                                           std::span<const NodePlace> places,
                                           const std::function<void()>& pause)
    : rank_of_(graph.node_count()) {
  NodeContraction contraction(graph, up_, down_);
  if (!places.empty() && graph.node_count() > 0) {
    const RestNetwork all = rest_of(contraction, places, node_of_);
    if (is_grid_like(all)) take_cells(contraction, all, pause);
  }
  if (node_of_.empty()) contract_one_by_one(graph, contraction, places, pause);
  for (Half* half : {&up_, &down_}) {
    if (half->first.size() == node_of_.size())
      half->first.push_back(static_cast<std::uint32_t>(half->arcs.size()));
    for (SearchArc& arc : half->arcs) arc.to = rank_of_[arc.to];
  }
}

void ContractionHierarchy::contract_one_by_one(const SearchGraph& graph,
                                               NodeContraction& contraction,
                                               std::span<const NodePlace> places,
                                               const std::function<void()>& pause) {
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
      take_cells(contraction, rest_of(contraction, places, node_of_), pause);
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
