#pragma once

#include <cstddef>
#include <vector>

#include "stope/payloads/grid_frame.hpp"
#include "stope/payloads/trajectory.hpp"

namespace stope::rasterizer {

/// The places (GridFrame::place) of the cells a route runs through, in its order, looked at every
/// half cell; a cell may come several times.
std::vector<std::size_t> route_cells(const GridFrame& frame, const Trajectory& trajectory);

}  // namespace stope::rasterizer
