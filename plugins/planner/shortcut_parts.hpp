#pragma once

#include <span>
#include <vector>

#include "plugins/planner/cell_contraction.hpp"

namespace stope::planner {

/// What each kept arc stands for: a link of the graph that costs the same, or a kept arc down and a
/// kept one up again (their numbers among `down` and `up`, to which `first_down` and `first_up` are
/// added). Of the arcs up, then of those down. See the .cpp for method and cost.
struct ShortcutParts {
  std::vector<ContractionHierarchy::Parts> up, down;
};
ShortcutParts shortcut_parts(const KeptHalves& kept, std::span<const CellLink> links,
                             std::uint32_t first_up, std::uint32_t first_down);

}  // namespace stope::planner
