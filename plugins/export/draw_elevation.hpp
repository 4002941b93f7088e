#pragma once

#include "plugins/export/canvas.hpp"
#include "plugins/export/map_view.hpp"
#include "stope/payloads/elevation_grid.hpp"

namespace stope::exports {

/// A relief of the ground: coloured by height from the lowest (green) to the highest (white),
/// shaded as if lit from the north-west. Unknown cells are grey.
Canvas draw_elevation(const ElevationGrid& grid, const MapView& view);

}  // namespace stope::exports
