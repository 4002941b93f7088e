#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

namespace stope::planner {

/// Cost of a whole way, in units of a graph's own choosing. Whole numbers, so that sums do not
/// depend on the order they are taken in and equal ways compare as equal.
using WayCost = std::uint64_t;
inline constexpr WayCost kNoWay = std::numeric_limits<WayCost>::max();
inline constexpr std::uint32_t kNoArc = std::numeric_limits<std::uint32_t>::max();

/// The far end of an arc and what driving it costs (at least 1).
struct SearchArc {
  std::uint32_t to = 0, cost = 1;
};

/// An arc as a graph is made of them.
struct ArcBetween {
  std::uint32_t from = 0, to = 0, cost = 1;
};

/// A directed graph in flat arrays, to be searched many times and never changed. Arcs are numbered
/// by the node they leave, then as they were given. 24 bytes an arc, 24 a node.
class SearchGraph {
 public:
  /// An arc seen from the node it enters.
  struct Into {
    std::uint32_t from = 0, arc = 0;
  };

  SearchGraph() : first_out_(1, 0), first_in_(1, 0) {}
  /// O(V + E). Ends of arcs must be below `nodes`; costs of 0 are raised to 1, so that no ring is
  /// free.
  SearchGraph(std::uint32_t nodes, std::span<const ArcBetween> arcs);

  std::uint32_t node_count() const { return static_cast<std::uint32_t>(first_out_.size() - 1); }
  std::uint32_t arc_count() const { return static_cast<std::uint32_t>(arcs_.size()); }
  std::uint32_t first_arc(std::uint32_t node) const { return first_out_[node]; }
  std::uint32_t end_arc(std::uint32_t node) const { return first_out_[node + 1]; }
  const SearchArc& arc(std::uint32_t number) const { return arcs_[number]; }
  std::uint32_t source(std::uint32_t arc) const { return sources_[arc]; }
  /// The place in the constructor's list of an arc.
  std::uint32_t given(std::uint32_t arc) const { return given_[arc]; }
  std::span<const Into> into(std::uint32_t node) const {
    return std::span(into_).subspan(first_in_[node], first_in_[node + 1] - first_in_[node]);
  }

 private:
  std::vector<std::uint32_t> first_out_, first_in_;  // node_count + 1
  std::vector<SearchArc> arcs_;
  std::vector<std::uint32_t> sources_, given_;
  std::vector<Into> into_;
};

}  // namespace stope::planner
