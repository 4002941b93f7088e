#pragma once

#include <filesystem>

#include "stope/payloads/occupancy_grid.hpp"

namespace stope::map_source {

/// Reads a MovingAI `.map` (type octile): `.`, `G` and `S` may be driven and are free; `@`, `O`,
/// `T` and `W` may not and are occupied. The file's first row becomes the grid's highest, so that a
/// scenario's (x, y) is the cell (x, height - 1 - y). `resolution` is in metres a cell. Throws
/// Error, naming the line and column.
OccupancyGrid read_movingai_map(const std::filesystem::path& file, double resolution);

}  // namespace stope::map_source
