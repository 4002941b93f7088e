#pragma once

#include <cstring>

#include "stope/payloads/occupancy_grid.hpp"
#include "stope/random.hpp"

namespace stope::topology {

/// Cells along a side of the grids below.
constexpr int kSide = 4096;

inline OccupancyGrid empty_grid(int width, int height, double resolution) {
  OccupancyGrid grid;
  grid.frame = {width, height, resolution, {}};
  grid.cells.assign(grid.frame.size(), OccupancyGrid::kOccupied);
  return grid;
}

/// Blocks of 64 x 64 cells, 60 % of them free.
inline OccupancyGrid city_blocks() {
  constexpr int kBlock = 64;
  Random random(1);
  OccupancyGrid grid = empty_grid(kSide, kSide, 0.5);
  for (int row = 0; row < kSide; row += kBlock)
    for (int column = 0; column < kSide; column += kBlock)
      if (random.uniform() < 0.6)
        for (int y = row; y < row + kBlock; ++y)
          std::memset(&grid.cells[grid.frame.place({column, y})], OccupancyGrid::kFree, kBlock);
  return grid;
}

}  // namespace stope::topology
