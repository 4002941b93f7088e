#pragma once

#include <vector>

#include "plugins/topology/courses.hpp"
#include "plugins/topology/padded_grid.hpp"

namespace stope::topology {

/// What a measurement depends on.
struct LookedAt {
  std::vector<LinePoint> places;  ///< beside or in all cells whose nearest obstacle was asked for
  std::vector<CellIndex> probed;  ///< cells that were asked whether they are obstacles
};

}  // namespace stope::topology
