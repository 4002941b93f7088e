#pragma once

#include <optional>
#include <vector>

#include "plugins/planner/cell_box.hpp"
#include "plugins/planner/drivable_grid.hpp"
#include "plugins/planner/road_ground.hpp"
#include "stope/payloads/road_graph.hpp"

namespace stope::planner {

/// The cells that a way no longer than `line` between the line's ends can touch.
CellBox cells_within_reach(const GridFrame& frame, const std::vector<RoadVertex>& line);
/// More cells are not searched.
constexpr std::size_t kMostShortcutCells = 64'000'000;

/// The shortest way over cells (eight neighbours, corners are not cut) from the first to the last
/// point of `line` through free ground in `box`, pulled straight where lines of sight allow. Its
/// cells' centres are at least `min_clearance` from those of the next that are not free, but for
/// the cells that `line` itself runs through; where `roads` says that metres cost more, the
/// cheapest such way. None if the free cells do not join the ends.
std::optional<std::vector<Vector2>> shortcut(const DrivableGrid& grid, const RoadGround& roads,
                                             const CellBox& box,
                                             const std::vector<RoadVertex>& line,
                                             double min_clearance);

}  // namespace stope::planner
