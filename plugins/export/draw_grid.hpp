#pragma once

#include "plugins/export/canvas.hpp"
#include "plugins/export/map_view.hpp"
#include "stope/payloads/occupancy_grid.hpp"

namespace stope::exports {

/// A picture of an occupancy grid: free light, occupied dark, unknown grey. Where a pixel takes
/// several cells it has their mean, but stays dark if any of them is occupied, so that a thin berm
/// does not vanish.
Canvas draw_grid(const OccupancyGrid& grid, const MapView& view);

}  // namespace stope::exports
