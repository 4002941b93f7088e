#pragma once

#include <cstddef>
#include <vector>

#include "plugins/topology/named_outlines.hpp"

namespace stope::topology {

/// A new outline.
struct OutlineRing {
  std::vector<OutlineEdge> names;    ///< of its edges, in order
  std::vector<std::int32_t> breaks;  ///< places in `names` where what was in a row before may end
  Outline outline;                   ///< but for its first number
  std::size_t start = 0;             ///< place in `names` of the edge with the first number
};

/// Puts rings in the place of outlines that are `gone`, and gives their edges numbers that no
/// outline has or had until now. Returns the rings' places, in order.
std::vector<std::int32_t> number_rings(const std::vector<OutlineRing>& rings,
                                       const std::vector<std::int32_t>& gone,
                                       NamedOutlines& outlines);

/// If too many numbers are unused, gives new ones to all outlines; whether it did.
bool renumber_if_sparse(NamedOutlines& outlines);

}  // namespace stope::topology
