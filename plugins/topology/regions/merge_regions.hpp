#pragma once

#include <vector>

#include "plugins/topology/regions/borders.hpp"
#include "plugins/topology/regions/merge_memo.hpp"
#include "plugins/topology/regions/region_shape.hpp"

namespace stope::topology {

/// When small regions are merged (Wang et al., sec. 2.2). Lengths in cells.
struct MergeRule {
  double radius = 5;            ///< regions with a smaller radius look for a neighbour
  double area = 700;            ///< most cells of the merged region
  double obstacle_ratio = 0.1;  ///< most unqualified cells in its hull for each of its own
  bool as_printed = false;      ///< Algorithm 2 to the letter, along Kruskal's tree
};

/// Merges regions by Algorithm 2, the smallest first, each with the neighbour it has the longest
/// border with that the rule allows. `names` are those of the cells; the set has one region for
/// each (of the same number, if as printed), and `shapes` are these, by name. `contacts` are those
/// of all tiles. What the memo knows of them is not computed again.
void merge_regions(const Ground& ground, const RegionCells& names,
                   const std::vector<RegionShape>& shapes, const std::vector<Contact>& contacts,
                   RegionSet& set, const MergeRule& rule, const Checkpoint& checkpoint,
                   MergeMemo* memo = nullptr);

}  // namespace stope::topology
