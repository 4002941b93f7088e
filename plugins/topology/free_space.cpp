#include "plugins/topology/free_space.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "plugins/topology/check_frame.hpp"
#include "stope/error.hpp"

namespace stope::topology {
namespace {

void check(const OccupancyGrid& grid) {
  const GridFrame& frame = grid.frame;
  check_frame(frame, grid.cells.size(), "occupancy");
  const auto padded =
      (static_cast<std::int64_t>(frame.width) + 2) * (static_cast<std::int64_t>(frame.height) + 2);
  if (padded > std::numeric_limits<CellIndex>::max())
    throw Error(
        fmt::format("the occupancy grid has {} x {} cells, more than the 2^31 a road graph "
                    "can be made of; use a coarser resolution or cut the map",
                    frame.width, frame.height));
}

/// The least cell value that is an obstacle; 255 if none is.
std::uint8_t least_occupied(const OccupancyRule& rule) {
  return static_cast<std::uint8_t>(
      std::clamp(std::ceil(rule.occupied_threshold * OccupancyGrid::kOccupied - 1e-9), 0.0, 255.0));
}

}  // namespace

FreeSpace make_free_space(const OccupancyGrid& grid, const OccupancyRule& rule,
                          const Checkpoint& checkpoint) {
  check(grid);
  FreeSpace space(grid.frame.width, grid.frame.height);
  const std::int32_t width = space.width(), height = space.height();
  const std::uint8_t least = least_occupied(rule);
  const std::uint8_t unknown = rule.unknown_is_obstacle ? kObstacle : 0;
  std::fill_n(space.padded_row(-1), space.stride(), kObstacle);
  std::fill_n(space.padded_row(height), space.stride(), kObstacle);
  bool any_free = false;
  for (std::int32_t row = 0; row < height; ++row) {
    if (row % kRowsBetweenCheckpoints == 0) checkpoint();
    const std::uint8_t* from =
        grid.cells.data() + static_cast<std::size_t>(row) * static_cast<std::size_t>(width);
    std::uint8_t* to = space.padded_row(row);
    to[0] = to[width + 1] = kObstacle;
    std::uint8_t all = kObstacle;
    for (std::int32_t column = 0; column < width; ++column) {
      const std::uint8_t value = from[column];
      const std::uint8_t known = value >= least ? kObstacle : 0;
      to[column + 1] = value == OccupancyGrid::kUnknown ? unknown : known;
      all &= to[column + 1];
    }
    any_free = any_free || all != kObstacle;
  }
  if (!any_free)
    throw Error(fmt::format(
        "the occupancy grid ({} x {} cells) has no free cell; check its thresholds, whether black "
        "and white are swapped (negate), and whether unknown cells should count as free",
        width, height));
  return space;
}

}  // namespace stope::topology
