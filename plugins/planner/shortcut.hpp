#pragma once

#include <optional>
#include <vector>

#include "plugins/planner/drivable_grid.hpp"
#include "stope/payloads/road_graph.hpp"

namespace stope::planner {

/// A way from the first to the last point of `lines`, which all begin and end alike, through the
/// free ground around them: no farther from a line's vertex than its clearance, pulled straight,
/// not past corners, and where the ends allow it through cells whose distance to the next that is
/// not free is at least `min_clearance`. None if the cells around the lines do not hang together,
/// or are too many (64 million).
std::optional<std::vector<Vector2>> shortcut_along(
    const DrivableGrid& grid, const std::vector<std::vector<RoadVertex>>& lines,
    double min_clearance);

/// Whether a straight line touches free cells only; where it runs through a corner of cells, all
/// that meet there count.
bool line_clear(const DrivableGrid& grid, const Vector2& a, const Vector2& b);

}  // namespace stope::planner
