#pragma once

#include <algorithm>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "plugins/planner/nested_dissection.hpp"
#include "plugins/planner/search_graph.hpp"

namespace stope::planner {

class NodeContraction;
struct RestNetwork;

/// A graph's nodes in an order of importance, and for each the arcs and shortcuts that join it to
/// more important ones, such that every cheapest way has an equally cheap one that first climbs and
/// then descends. Nodes are known by rank here: 0 is the least important.
class ContractionHierarchy {
 public:
  /// What a shortcut stands for: an arc down to a less important node (its place among the arcs
  /// down) and one up from there (its place among the arcs up). `down` is kNoArc for an arc of the
  /// graph; `up` is its number then.
  struct Parts {
    std::uint32_t down = kNoArc, up = 0;
  };

  /// See the .cpp for method and cost. Keeps no reference to the graph. `places` of all nodes, or
  /// none: with them dense networks such as grids are feasible too. Calls `pause` now and then,
  /// which may throw to give up. Throws Error if a way between two nodes costs too much for 32
  /// bits.
  explicit ContractionHierarchy(
      const SearchGraph& graph, std::span<const NodePlace> places = {},
      const std::function<void()>& pause = [] {});

  std::uint32_t node_count() const { return static_cast<std::uint32_t>(node_of_.size()); }
  std::uint32_t rank(std::uint32_t node) const { return rank_of_[node]; }
  std::uint32_t node(std::uint32_t rank) const { return node_of_[rank]; }
  /// Whether all nodes that a climb from one can come to stand in a chain, which next() follows.
  bool has_chains() const { return !next_.empty(); }
  /// The rank after one in its chain; kNoArc after the last.
  std::uint32_t next(std::uint32_t rank) const { return next_[rank]; }
  /// Arcs from a node to more important ones (`up`), and to it from more important ones (`down`,
  /// whose SearchArc::to is where they come from). Arcs of all nodes stand in one array each.
  struct Half {
    std::vector<std::uint32_t> first;  // node_count + 1
    std::vector<SearchArc> arcs;
    std::vector<Parts> parts;
    std::span<const SearchArc> of(std::uint32_t rank) const {
      return std::span(arcs).subspan(first[rank], first[rank + 1] - first[rank]);
    }
    /// Asks the memory for a node's arcs, which are to be looked at soon. Always inlined: g++ drops
    /// calls of a function that does nothing else.
    [[gnu::always_inline]] void fetch(std::uint32_t rank) const {
      constexpr std::uint32_t kLine = 64 / sizeof(SearchArc);
      for (std::uint32_t place = first[rank]; place < first[rank + 1]; place += kLine)
        __builtin_prefetch(arcs.data() + place);
    }
    /// The less important end of an arc.
    std::uint32_t lower_end(std::uint32_t place) const {
      const auto after = std::upper_bound(first.begin(), first.end(), place);
      return static_cast<std::uint32_t>(after - first.begin() - 1);
    }
  };
  const Half& up() const { return up_; }
  const Half& down() const { return down_; }
  /// Appends the arcs of the graph that an arc up (or down) stands for, as they are driven.
  void unpack_up(std::uint32_t place, std::vector<std::uint32_t>& arcs) const;
  void unpack_down(std::uint32_t place, std::vector<std::uint32_t>& arcs) const;

 private:
  void take_cells(const NodeContraction& contraction, const RestNetwork& rest,
                  const std::function<void()>& pause);
  void contract_one_by_one(const SearchGraph& graph, NodeContraction& contraction,
                           std::span<const NodePlace> places, const std::function<void()>& pause);
  void unpack(const Parts& parts, std::vector<std::uint32_t>& arcs) const;

  std::vector<std::uint32_t> rank_of_, node_of_, next_;
  Half up_, down_;
};

}  // namespace stope::planner
