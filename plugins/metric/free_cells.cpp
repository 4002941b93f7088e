#include "plugins/metric/free_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "stope/error.hpp"

namespace stope::metric {
namespace {

void check(const OccupancyGrid& grid) {
  const GridFrame& frame = grid.frame;
  if (frame.width <= 0 || frame.height <= 0)
    throw Error(fmt::format("the occupancy grid at 'grid' is empty ({} x {} cells)", frame.width,
                            frame.height));
  if (grid.cells.size() != frame.size())
    throw Error(fmt::format(
        "the occupancy grid at 'grid' says {} x {} cells but holds {}; its source is at fault",
        frame.width, frame.height, grid.cells.size()));
  if (!(frame.resolution > 0) || !std::isfinite(frame.resolution))
    throw Error(
        fmt::format("the occupancy grid at 'grid' has a resolution of {} m a cell; it must "
                    "be a positive number",
                    frame.resolution));
  if (!std::isfinite(frame.origin.x) || !std::isfinite(frame.origin.y) ||
      !std::isfinite(frame.origin.yaw))
    throw Error(
        fmt::format("the occupancy grid at 'grid' has its origin at ({}, {}, {}), which is "
                    "not a place",
                    frame.origin.x, frame.origin.y, frame.origin.yaw));
}

}  // namespace

FreeCells free_cells(const OccupancyGrid& grid, const FreeRule& rule) {
  check(grid);
  const double least = rule.occupied_threshold * OccupancyGrid::kOccupied - 1e-9;
  FreeCells cells;
  cells.frame = grid.frame;
  cells.free.resize(grid.cells.size());
  std::transform(grid.cells.begin(), grid.cells.end(), cells.free.begin(), [&](std::uint8_t cell) {
    const bool obstacle =
        cell == OccupancyGrid::kUnknown ? rule.unknown_is_obstacle : cell >= least;
    return static_cast<std::uint8_t>(obstacle ? 0 : 1);
  });
  cells.count = static_cast<std::size_t>(std::count(cells.free.begin(), cells.free.end(), 1));
  if (cells.count == 0)
    throw Error(
        fmt::format("the occupancy grid at 'grid' has no free cell, so there is nothing to "
                    "measure a graph against: look at its source, and at "
                    "occupied_threshold ({}) and unknown_is_obstacle ({})",
                    rule.occupied_threshold, rule.unknown_is_obstacle));
  return cells;
}

}  // namespace stope::metric
