#pragma once

#include <cstdint>
#include <vector>

#include "plugins/planner/contraction_hierarchy.hpp"
#include "plugins/planner/search_labels.hpp"

namespace stope::planner {

/// The graph that is left while a contraction hierarchy is made: nodes leave it one by one, and
/// their arcs go into the hierarchy's halves, whose ends are nodes yet, not ranks.
class NodeContraction {
 public:
  using Half = ContractionHierarchy::Half;
  using Parts = ContractionHierarchy::Parts;

  /// To or from another node that is left.
  struct Link {
    std::uint32_t other = 0, cost = 0, hops = 1;
    Parts parts;
  };

  NodeContraction(const SearchGraph& graph, Half& up, Half& down);
  /// How late a node should be taken out.
  std::uint64_t importance(std::uint32_t node);
  /// Takes a node out, adds the shortcuts that this asks for, and lists the nodes it was joined to.
  void contract(std::uint32_t node, std::vector<std::uint32_t>& neighbours);
  /// Links between the nodes that are left.
  std::uint64_t link_count() const { return link_count_; }
  const std::vector<Link>& links_from(std::uint32_t node) const { return out_[node]; }
  const std::vector<Link>& links_to(std::uint32_t node) const { return in_[node]; }

 private:
  struct Shortcut {
    std::uint32_t from, to, cost, hops;
    std::uint32_t in, out;  // places in in_[node], out_[node]
  };

  void find_shortcuts(std::uint32_t node, std::uint32_t limit);
  void search_witnesses(std::uint32_t from, std::uint32_t without, WayCost most,
                        std::uint32_t limit);
  static bool join(std::vector<Link>& links, const Link& link);
  static void cut(std::vector<Link>& links, std::uint32_t other);

  std::vector<std::vector<Link>> out_, in_;
  std::uint64_t link_count_ = 0;
  std::vector<std::uint32_t> levels_;
  Half &up_, &down_;
  std::vector<Shortcut> shortcuts_;
  SearchLabels labels_;
  SearchHeap<WayCost> heap_;
  std::vector<std::uint32_t> wanted_;  // per node: the search that still waits for it
  std::uint32_t search_ = 0, waiting_ = 0;
};

}  // namespace stope::planner
