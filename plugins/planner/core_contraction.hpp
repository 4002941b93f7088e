#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "plugins/planner/contraction_hierarchy.hpp"

namespace stope::planner {

/// A link between two nodes of a core, as it goes into a hierarchy.
struct CoreLink {
  std::uint32_t from = 0, to = 0;  ///< by place in the order
  std::uint32_t cost = 0;
  ContractionHierarchy::Parts parts;
};

/// Takes all nodes of a core out in the given order (node numbers, least important first) and
/// appends their arcs and shortcuts to the hierarchy's halves, which it closes. Ends of arcs there
/// are node numbers. `links` are sorted by (from, to) and unique. See the .cpp for method and cost.
/// Throws Error if a way costs 2^30 or more.
void contract_core(std::span<const std::uint32_t> order, std::span<const CoreLink> links,
                   ContractionHierarchy::Half& up, ContractionHierarchy::Half& down,
                   const std::function<void()>& pause);

}  // namespace stope::planner
