#pragma once

#include <cstddef>
#include <string_view>

#include "stope/payloads/grid_frame.hpp"

namespace stope::topology {

/// Throws Error if a grid of the kind `name` ("occupancy", "elevation") is empty, has another
/// number of cells than its frame says, a resolution outside of 1 mm to 1 km, or an origin that is
/// not a number.
void check_frame(const GridFrame& frame, std::size_t cells, std::string_view name);

}  // namespace stope::topology
