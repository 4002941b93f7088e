#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "plugins/planner/search_graph.hpp"

namespace stope::planner {

/// What a search knows of each node. Forgotten in O(1): a label counts only if it was written since
/// the last clear(), so a query costs what it touches and nothing for the rest of the graph.
class SearchLabels {
 public:
  void resize(std::uint32_t nodes) { labels_.resize(nodes); }
  void clear() {
    if (++now_ != 0) return;
    for (Label& label : labels_) label.written = 0;
    now_ = 1;
  }
  bool known(std::uint32_t node) const { return labels_[node].written == now_; }
  /// kNoWay where nothing was written.
  WayCost cost(std::uint32_t node) const { return known(node) ? labels_[node].cost : kNoWay; }
  /// The arc by which a known node was reached; kNoArc for a source.
  std::uint32_t arc(std::uint32_t node) const { return labels_[node].arc; }
  /// cost() and, if it costs less than that now, set() for nodes that are known.
  WayCost known_cost(std::uint32_t node) const { return labels_[node].cost; }
  void lower_known(std::uint32_t node, WayCost cost, std::uint32_t arc) {
    Label& label = labels_[node];
    if (cost < label.cost) label.cost = cost, label.arc = arc;
  }
  void set(std::uint32_t node, WayCost cost, std::uint32_t arc) {
    labels_[node] = {cost, arc, now_};
  }

 private:
  struct Label {
    WayCost cost = 0;
    std::uint32_t arc = kNoArc, written = 0;
  };
  std::vector<Label> labels_;
  std::uint32_t now_ = 0;
};

/// A heap of nodes, cheapest key first, equal keys by node, with stale entries instead of decreased
/// keys.
template <class Key>
class SearchHeap {
 public:
  struct Entry {
    Key key;
    std::uint32_t node;
  };
  bool empty() const { return entries_.empty(); }
  void clear() { entries_.clear(); }
  const Entry& top() const { return entries_.front(); }
  void push(Key key, std::uint32_t node) {
    entries_.push_back({key, node});
    std::push_heap(entries_.begin(), entries_.end(), later);
  }
  Entry pop() {
    std::pop_heap(entries_.begin(), entries_.end(), later);
    const Entry entry = entries_.back();
    entries_.pop_back();
    return entry;
  }

 private:
  static bool later(const Entry& a, const Entry& b) {
    return a.key != b.key ? b.key < a.key : b.node < a.node;
  }
  std::vector<Entry> entries_;
};

}  // namespace stope::planner
