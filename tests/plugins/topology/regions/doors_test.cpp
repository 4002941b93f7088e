#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "plugins/topology/regions/clearance_basins.hpp"
#include "tests/plugins/topology/test_grids.hpp"

namespace stope::topology {
namespace {

/// Two rooms of 20 x 20 cells with a wall of two cells and a door of `door` cells in it.
OccupancyGrid two_rooms(std::int32_t door) {
  return grid_where(44, 22, 1, [&](double x, double y) {
    const bool room = x > 1 && x < 43 && y > 1 && y < 21;
    const bool wall = x > 21 && x < 23 && std::abs(y - 11) > door / 2.0;
    return room && !wall;
  });
}

std::int32_t rooms_of(const OccupancyGrid& grid, double door_ratio, RegionCells* cells = nullptr) {
  ExtractionParams params;
  params.min_obstacle_area = 0;
  const Ground ground(grid, params);
  std::int32_t count = 0;
  RegionCells regions = divide_at_doors(ground, {door_ratio, 1, 1}, count, [] {});
  if (cells) *cells = std::move(regions);
  return count;
}

TEST(Doors, ADoorDividesAndAWideOpeningDoesNot) {
  EXPECT_EQ(rooms_of(two_rooms(4), 0.8), 2);
  EXPECT_EQ(rooms_of(two_rooms(12), 0.8), 2);
  EXPECT_EQ(rooms_of(two_rooms(12), 0.5), 1);
  EXPECT_EQ(rooms_of(two_rooms(20), 0.8), 1);
}

TEST(Doors, TheBorderRunsThroughTheDoor) {
  RegionCells regions(1, 1);
  ASSERT_EQ(rooms_of(two_rooms(4), 0.8, &regions), 2);
  const std::int32_t left = regions[regions.index(5, 10)], right = regions[regions.index(38, 10)];
  EXPECT_NE(left, right);
  for (std::int32_t row = 1; row < 21; ++row) {
    for (std::int32_t column = 1; column < 43; ++column) {
      const std::int32_t region = regions[regions.index(column, row)];
      if (column >= 20 && column <= 23) continue;
      EXPECT_EQ(region, column < 20 ? left : right) << column << ", " << row;
    }
  }
}

TEST(Doors, EveryFreeCellIsInARegionAndNoOther) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const OccupancyGrid grid = random_grid(50, 40, 0.7, 2, seed);
    RegionCells regions(1, 1);
    const std::int32_t count = rooms_of(grid, 0.8, &regions);
    std::set<std::int32_t> used;
    for (std::int32_t row = 0; row < 40; ++row) {
      for (std::int32_t column = 0; column < 50; ++column) {
        const std::int32_t region = regions[regions.index(column, row)];
        const bool free = grid.cells[grid.frame.place({column, row})] == OccupancyGrid::kFree;
        EXPECT_EQ(region > 0, free);
        if (free) used.insert(region);
      }
    }
    EXPECT_EQ(used.size(), static_cast<std::size_t>(count));
    EXPECT_EQ(*used.rbegin(), count);
  }
}

}  // namespace
}  // namespace stope::topology
