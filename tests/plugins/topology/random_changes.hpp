#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "plugins/topology/column_reach.hpp"
#include "stope/payloads/occupancy_grid.hpp"
#include "stope/random.hpp"

namespace stope::topology {

/// What may happen to a map between two looks at it.
enum class ChangeKind {
  kObstacleAppears,  ///< a disc, as of a parked truck or a heap
  kObstacleGoes,     ///< a disc becomes free
  kRoadIsCut,        ///< a wall across the window
  kRoadOpens,        ///< a lane across the window
  kRoughFaces,       ///< cells at the border between free and occupied flip
  kAllBlocked,
  kAllFree,
  kSpeckles,  ///< a few single cells flip
  kNothing,   ///< the window says more than has changed
};
constexpr int kChangeKinds = 9;

/// A whole number from `low` to `high`.
inline std::int32_t draw(std::int32_t low, std::int32_t high, Random& random) {
  return low + static_cast<std::int32_t>(random.uniform() * (high - low + 1));
}

/// A window of `side` x `side` cells, which may reach beyond the grid's border.
inline CellWindow draw_window(const OccupancyGrid& grid, std::int32_t side, Random& random) {
  const std::int32_t column = draw(-side / 2, grid.frame.width - side / 2, random);
  const std::int32_t row = draw(-side / 2, grid.frame.height - side / 2, random);
  return {column, row, side, side};
}

/// Changes a grid within a window.
inline void change_within(OccupancyGrid& grid, const CellWindow& window, ChangeKind kind,
                          Random& random) {
  const std::int32_t column = window.column, row = window.row, side = window.width;
  const auto set = [&](std::int32_t x, std::int32_t y, std::uint8_t value) {
    if (x < column || y < row || x >= column + side || y >= row + side) return;
    if (grid.frame.contains({x, y})) grid.cells[grid.frame.place({x, y})] = value;
  };
  const auto free = [&](std::int32_t x, std::int32_t y) {
    return grid.frame.contains({x, y}) &&
           grid.cells[grid.frame.place({x, y})] == OccupancyGrid::kFree;
  };
  const auto flip = [&](std::int32_t x, std::int32_t y) {
    set(x, y, free(x, y) ? OccupancyGrid::kOccupied : OccupancyGrid::kFree);
  };
  const auto disc = [&](std::uint8_t value) {
    const double radius = random.uniform(1.0, side / 2.0);
    for (std::int32_t y = 0; y < side; ++y)
      for (std::int32_t x = 0; x < side; ++x)
        if (std::hypot(x - side / 2.0, y - side / 2.0) <= radius) set(column + x, row + y, value);
  };
  const auto band = [&](std::uint8_t value) {
    const double angle = random.uniform(0.0, 3.1416), half = random.uniform(0.6, side / 8.0);
    for (std::int32_t y = 0; y < side; ++y)
      for (std::int32_t x = 0; x < side; ++x)
        if (std::abs((x - side / 2.0) * std::cos(angle) + (y - side / 2.0) * std::sin(angle)) <=
            half)
          set(column + x, row + y, value);
  };
  const auto fill = [&](std::uint8_t value) {
    for (std::int32_t y = 0; y < side; ++y)
      for (std::int32_t x = 0; x < side; ++x) set(column + x, row + y, value);
  };
  switch (kind) {
    case ChangeKind::kObstacleAppears:
      disc(OccupancyGrid::kOccupied);
      break;
    case ChangeKind::kObstacleGoes:
      disc(OccupancyGrid::kFree);
      break;
    case ChangeKind::kRoadIsCut:
      band(OccupancyGrid::kOccupied);
      break;
    case ChangeKind::kRoadOpens:
      band(OccupancyGrid::kFree);
      break;
    case ChangeKind::kRoughFaces: {
      const OccupancyGrid before = grid;
      const auto was_free = [&](std::int32_t x, std::int32_t y) {
        return before.frame.contains({x, y}) &&
               before.cells[before.frame.place({x, y})] == OccupancyGrid::kFree;
      };
      for (std::int32_t y = row; y < row + side; ++y)
        for (std::int32_t x = column; x < column + side; ++x) {
          const bool own = was_free(x, y);
          const bool at_face = own != was_free(x + 1, y) || own != was_free(x - 1, y) ||
                               own != was_free(x, y + 1) || own != was_free(x, y - 1);
          if (at_face && random.uniform() < 0.3) flip(x, y);
        }
      break;
    }
    case ChangeKind::kAllBlocked:
      fill(OccupancyGrid::kOccupied);
      break;
    case ChangeKind::kAllFree:
      fill(OccupancyGrid::kFree);
      break;
    case ChangeKind::kSpeckles:
      for (int i = 0; i < 12; ++i)
        flip(draw(column, column + side, random), draw(row, row + side, random));
      break;
    case ChangeKind::kNothing:
      break;
  }
}

/// The same in a window anywhere, which it returns.
inline CellWindow change_at_random(OccupancyGrid& grid, std::int32_t side, ChangeKind kind,
                                   Random& random) {
  const CellWindow window = draw_window(grid, side, random);
  change_within(grid, window, kind, random);
  return window;
}

}  // namespace stope::topology
