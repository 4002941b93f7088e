#pragma once

#include <cstdint>
#include <vector>

namespace stope::topology {

/// A link between two of `count` places.
struct RegionLink {
  std::int32_t from = 0, to = 0;
  double length = 0;
};

/// Places in `links` of those that make a tree of each connected part, of least total length
/// (Kruskal 1956), in increasing order. Of equally long ones the earlier is taken.
std::vector<std::size_t> spanning_tree(std::int32_t count, const std::vector<RegionLink>& links);

/// Places in `links` of those that keep every way between two places at most `stretch` times as
/// long as it was (the greedy spanner; Althoefer et al. 1993), in increasing order.
std::vector<std::size_t> spanner(std::int32_t count, const std::vector<RegionLink>& links,
                                 double stretch);

}  // namespace stope::topology
