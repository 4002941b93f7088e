#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "plugins/planner/cell_borders.hpp"

namespace stope::planner {

/// Arcs that a hierarchy keeps, by the place of their lower end, then of their higher one.
struct KeptArcs {
  std::vector<std::uint32_t> first{0};  ///< of each lower end
  std::vector<SearchArc> arcs;          ///< to the higher end, by place
};

struct KeptHalves {
  KeptArcs up, down;  ///< from the lower end to the higher one, and the other way
};

/// Takes all nodes out in the dissection's order. Of the arcs and shortcuts between two nodes only
/// those are kept without which a cheapest way would be lost. The same on any number of threads.
/// See the .cpp for method and cost. Throws Error if a way costs 2^30 or more.
KeptHalves contract_cells(const Dissection& dissection, const CellBorders& borders,
                          std::span<const CellLink> links, const std::function<void()>& pause);

}  // namespace stope::planner
