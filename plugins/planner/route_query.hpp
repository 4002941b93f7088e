#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plugins/planner/search_graph.hpp"

namespace stope::planner {

/// A node where a way may begin or end, and what it costs to come to it or to go on from it.
struct WayEnd {
  std::uint32_t node = 0;
  WayCost cost = 0;
};

/// A cheapest way: the arcs in the order they are driven. Without arcs where a source is a target.
struct Way {
  WayCost cost = kNoWay;
  std::uint32_t source = 0, target = 0;  ///< nodes; only if `cost` is not kNoWay
  std::vector<std::uint32_t> arcs;
  std::uint32_t settled = 0;  ///< nodes the search took from its heaps
  bool found() const { return cost != kNoWay; }
};

/// Costs that differ from the graph's for one query, without a copy of it. They may only rise: all
/// lower bounds taken from the unchanged graph stay valid then. A small hash table of its own, so
/// that the unchanged arcs, nearly all, cost one look into the first-level cache.
class CostChanges {
 public:
  /// The arc cannot be driven.
  void block(std::uint32_t arc) { put(arc, kNoWay); }
  /// The arc costs `cost` now. A cost below the graph's own counts as the graph's own.
  void raise(std::uint32_t arc, WayCost cost) { put(arc, cost); }
  void clear();
  bool empty() const { return count_ == 0; }
  /// What an arc that costs `cost` in the graph costs now; kNoWay if it is blocked.
  WayCost cost(std::uint32_t arc, std::uint32_t cost) const {
    if (count_ == 0) return cost;
    for (std::size_t i = slot(arc);; i = (i + 1) & (slots_.size() - 1)) {
      if (slots_[i].arc == arc) return slots_[i].cost < cost ? cost : slots_[i].cost;
      if (slots_[i].arc == kNoArc) return cost;
    }
  }

 private:
  struct Slot {
    std::uint32_t arc = kNoArc;
    WayCost cost = 0;
  };
  std::size_t slot(std::uint32_t arc) const {
    return (arc * 0x9E3779B1U >> 7U) & (slots_.size() - 1);
  }
  void put(std::uint32_t arc, WayCost cost);

  std::vector<Slot> slots_;  // a power of two, at most half full
  std::size_t count_ = 0;
};

}  // namespace stope::planner
