#include "plugins/topology/free_space.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

#include "plugins/topology/check_frame.hpp"
#include "plugins/topology/for_each_band.hpp"
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

}  // namespace

std::uint8_t least_occupied(const OccupancyRule& rule) {
  return static_cast<std::uint8_t>(
      std::clamp(std::ceil(rule.occupied_threshold * OccupancyGrid::kOccupied - 1e-9), 0.0, 255.0));
}

namespace {

/// The values that are obstacles.
struct Obstacles {
  explicit Obstacles(const OccupancyRule& rule) : least(least_occupied(rule)) {
    // Unknown is the highest value.
    const int last = OccupancyGrid::kUnknown - (rule.unknown_is_obstacle ? 0 : 1);
    none = last < least;
    range = static_cast<std::uint8_t>(none ? 0 : last - least);
  }
  std::uint8_t least = 0, range = 0;  ///< from `least` to `least` + `range`
  bool none = false;
};

/// Whether any cell of the row is free.
bool split_row(const std::uint8_t* values, std::uint8_t* bits, std::int32_t width,
               const Obstacles& obstacles) {
  if (obstacles.none) {
    std::fill_n(bits, width, std::uint8_t{0});
    return true;
  }
  // One comparison of bytes, so that sixteen cells go at once.
  const std::uint8_t least = obstacles.least, range = obstacles.range;
  std::uint8_t all = kObstacle;
  for (std::int32_t column = 0; column < width; ++column) {
    const auto above_least = static_cast<std::uint8_t>(values[column] - least);
    bits[column] = above_least <= range ? kObstacle : 0;
    all &= bits[column];
  }
  return all != kObstacle;
}

}  // namespace

FreeSpace make_free_space(const OccupancyGrid& grid, const OccupancyRule& rule,
                          const Checkpoint& checkpoint) {
  check(grid);
  FreeSpace space(grid.frame.width, grid.frame.height);
  const std::int32_t width = space.width(), height = space.height();
  const Obstacles obstacles(rule);
  std::fill_n(space.padded_row(-1), space.stride(), kObstacle);
  std::fill_n(space.padded_row(height), space.stride(), kObstacle);
  std::atomic<bool> any_free = false;
  const std::int32_t bands = (height + kRowsBetweenCheckpoints - 1) / kRowsBetweenCheckpoints;
  for_each_band(bands, checkpoint, [&] {
    return [&](std::int32_t band) {
      const std::int32_t bottom = band * kRowsBetweenCheckpoints;
      const std::int32_t top = std::min(bottom + kRowsBetweenCheckpoints, height);
      for (std::int32_t row = bottom; row < top; ++row) {
        std::uint8_t* bits = space.padded_row(row);
        bits[0] = bits[width + 1] = kObstacle;
        if (split_row(grid.cells.data() + grid.frame.place({0, row}), bits + 1, width, obstacles))
          any_free = true;
      }
    };
  });
  if (!any_free)
    throw Error(fmt::format(
        "the occupancy grid ({} x {} cells) has no free cell; check its thresholds, whether black "
        "and white are swapped (negate), and whether unknown cells should count as free",
        width, height));
  return space;
}

}  // namespace stope::topology
