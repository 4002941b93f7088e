#include "plugins/planner/node_contraction.hpp"

#include <algorithm>

#include "stope/error.hpp"

namespace stope::planner {
namespace {

// Links a search for witnesses may look along: few when only the importance is asked, more when the
// shortcuts are to stay.
constexpr std::uint32_t kGlance = 500, kLook = 4000;

}  // namespace

NodeContraction::NodeContraction(const SearchGraph& graph, Half& up, Half& down)
    : out_(graph.node_count()),
      in_(graph.node_count()),
      levels_(graph.node_count(), 0),
      up_(up),
      down_(down),
      wanted_(graph.node_count(), 0) {
  labels_.resize(graph.node_count());
  for (std::uint32_t node = 0; node < graph.node_count(); ++node) {
    for (std::uint32_t arc = graph.first_arc(node); arc < graph.end_arc(node); ++arc) {
      const SearchArc& step = graph.arc(arc);
      if (step.to == node) continue;
      link_count_ += join(out_[node], {step.to, step.cost, 1, {kNoArc, arc}});
      join(in_[step.to], {node, step.cost, 1, {kNoArc, arc}});
    }
  }
}

/// Adds a link; of two to the same node the cheaper stays, of equals the first. Whether there was
/// none before.
bool NodeContraction::join(std::vector<Link>& links, const Link& link) {
  for (Link& old : links) {
    if (old.other != link.other) continue;
    if (link.cost < old.cost) old = link;
    return false;
  }
  links.push_back(link);
  return true;
}

void NodeContraction::cut(std::vector<Link>& links, std::uint32_t other) {
  const auto at = std::find_if(links.begin(), links.end(),
                               [&](const Link& link) { return link.other == other; });
  *at = links.back();
  links.pop_back();
}

void NodeContraction::search_witnesses(std::uint32_t from, std::uint32_t without, WayCost most,
                                       std::uint32_t limit) {
  labels_.clear();
  heap_.clear();
  labels_.set(from, 0, kNoArc);
  heap_.push(0, from);
  for (std::uint32_t looked = 0; !heap_.empty() && looked < limit && waiting_ > 0;) {
    const auto [cost, node] = heap_.pop();
    if (cost > labels_.cost(node)) continue;
    if (wanted_[node] == search_) {
      wanted_[node] = 0;
      --waiting_;
    }
    looked += static_cast<std::uint32_t>(out_[node].size());
    for (const Link& link : out_[node]) {
      const WayCost further = cost + link.cost;
      if (link.other == without || further > most || further >= labels_.cost(link.other)) continue;
      labels_.set(link.other, further, kNoArc);
      heap_.push(further, link.other);
    }
  }
}

void NodeContraction::find_shortcuts(std::uint32_t node, std::uint32_t limit) {
  shortcuts_.clear();
  const auto &in = in_[node], &out = out_[node];
  for (std::uint32_t i = 0; i < in.size(); ++i) {
    WayCost most = 0;
    waiting_ = 0;
    if (++search_ == 0) {
      std::fill(wanted_.begin(), wanted_.end(), 0);
      search_ = 1;
    }
    for (const Link& link : out) {
      if (link.other == in[i].other) continue;
      most = std::max<WayCost>(most, link.cost);
      wanted_[link.other] = search_;
      ++waiting_;
    }
    if (waiting_ == 0) continue;
    search_witnesses(in[i].other, node, in[i].cost + most, limit);
    for (std::uint32_t k = 0; k < out.size(); ++k) {
      if (out[k].other == in[i].other) continue;
      const WayCost cost = static_cast<WayCost>(in[i].cost) + out[k].cost;
      if (labels_.cost(out[k].other) <= cost) continue;
      if (cost >= kNoArc)
        throw Error("the road graph has ways too long to prepare for fast search");
      shortcuts_.push_back({in[i].other, out[k].other, static_cast<std::uint32_t>(cost),
                            in[i].hops + out[k].hops, i, k});
    }
  }
}

std::uint64_t NodeContraction::importance(std::uint32_t node) {
  find_shortcuts(node, kGlance);
  std::uint64_t removed = 1, removed_hops = 1, added_hops = 0;
  for (const auto* links : {&in_[node], &out_[node]}) {
    removed += links->size();
    for (const Link& link : *links) removed_hops += link.hops;
  }
  for (const Shortcut& shortcut : shortcuts_) added_hops += shortcut.hops;
  return 1000ULL * levels_[node] + 1000ULL * shortcuts_.size() / removed +
         1000ULL * added_hops / removed_hops;
}

void NodeContraction::contract(std::uint32_t node, std::vector<std::uint32_t>& neighbours) {
  find_shortcuts(node, kLook);
  const auto first_up = static_cast<std::uint32_t>(up_.arcs.size());
  const auto first_down = static_cast<std::uint32_t>(down_.arcs.size());
  up_.first.push_back(first_up);
  down_.first.push_back(first_down);
  neighbours.clear();
  for (const Link& link : out_[node]) {
    up_.arcs.push_back({link.other, link.cost});
    up_.parts.push_back(link.parts);
    cut(in_[link.other], node);
    neighbours.push_back(link.other);
  }
  for (const Link& link : in_[node]) {
    down_.arcs.push_back({link.other, link.cost});
    down_.parts.push_back(link.parts);
    cut(out_[link.other], node);
    neighbours.push_back(link.other);
  }
  for (const Shortcut& shortcut : shortcuts_) {
    const Parts parts{first_down + shortcut.in, first_up + shortcut.out};
    link_count_ += join(out_[shortcut.from], {shortcut.to, shortcut.cost, shortcut.hops, parts});
    join(in_[shortcut.to], {shortcut.from, shortcut.cost, shortcut.hops, parts});
  }
  link_count_ -= out_[node].size() + in_[node].size();
  // Storage of nodes that are gone is the greater part of the memory otherwise.
  std::vector<Link>().swap(out_[node]);
  std::vector<Link>().swap(in_[node]);
  std::sort(neighbours.begin(), neighbours.end());
  neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
  for (const std::uint32_t other : neighbours)
    levels_[other] = std::max(levels_[other], levels_[node] + 1);
}

}  // namespace stope::planner
