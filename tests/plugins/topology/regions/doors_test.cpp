#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "plugins/topology/regions/room_divider.hpp"
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

RegionMap rooms_of(const OccupancyGrid& grid, double door_ratio) {
  ExtractionParams params;
  params.min_obstacle_area = 0;
  return RoomDivider(params, {door_ratio, 1, 1, 0}, {}).full(grid, false).map;
}

std::size_t count_of(const OccupancyGrid& grid, double door_ratio) {
  return rooms_of(grid, door_ratio).regions.size();
}

TEST(Doors, ADoorDividesAndAWideOpeningDoesNot) {
  EXPECT_EQ(count_of(two_rooms(4), 0.8), 2U);
  EXPECT_EQ(count_of(two_rooms(12), 0.8), 2U);
  EXPECT_EQ(count_of(two_rooms(12), 0.5), 1U);
  EXPECT_EQ(count_of(two_rooms(20), 0.8), 1U);
}

TEST(Doors, TheBorderRunsThroughTheDoor) {
  const RegionMap map = rooms_of(two_rooms(4), 0.8);
  ASSERT_EQ(map.regions.size(), 2U);
  const auto at = [&](std::int32_t column, std::int32_t row) {
    return map.labels.cells[map.labels.frame.place({column, row})];
  };
  const std::int32_t left = at(5, 10), right = at(38, 10);
  EXPECT_NE(left, right);
  for (std::int32_t row = 1; row < 21; ++row) {
    for (std::int32_t column = 1; column < 43; ++column) {
      const std::int32_t region = at(column, row);
      if (column >= 20 && column <= 23) continue;
      EXPECT_EQ(region, column < 20 ? left : right) << column << ", " << row;
    }
  }
}

TEST(Doors, EveryFreeCellIsInARegionAndNoOther) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const OccupancyGrid grid = random_grid(50, 40, 0.7, 2, seed);
    const RegionMap map = rooms_of(grid, 0.8);
    std::set<std::int32_t> used;
    for (std::size_t i = 0; i < grid.cells.size(); ++i) {
      const std::int32_t region = map.labels.cells[i];
      EXPECT_EQ(region > 0, grid.cells[i] == OccupancyGrid::kFree);
      if (region > 0) used.insert(region);
    }
    EXPECT_EQ(used.size(), map.regions.size());
    EXPECT_EQ(*used.rbegin(), static_cast<std::int32_t>(map.regions.size()));
  }
}

/// Three halls in a row, each with a room above and one below, with doors of 4 cells; between the
/// halls the way is `opening` of their 20 cells wide.
OccupancyGrid halls_with_rooms(std::int32_t opening) {
  return grid_where(70, 66, 1, [&](double x, double y) {
    if (x < 2 || x > 68 || y < 1 || y > 65) return false;
    const double in_hall = std::fmod(x - 2, 22.0);
    if (y > 21 && y < 23) return std::abs(in_hall - 11) < 2;  // doors down
    if (y > 43 && y < 45) return std::abs(in_hall - 11) < 2;  // doors up
    const bool wall = in_hall > 20 || x < 4;
    if (y > 23 && y < 43) return !wall || (x > 4 && std::abs(y - 33) < opening / 2.0);
    return !wall;
  });
}

TEST(Doors, HallsThatAreOpenToEachOtherAreOneCorridorAndTheirRoomsAreNot) {
  ExtractionParams params;
  params.min_obstacle_area = 0;
  const auto count = [&](std::int32_t opening, double hub_ratio) {
    return RoomDivider(params, {0.99, 0.88, hub_ratio, 0}, {})
        .full(halls_with_rooms(opening), false)
        .map.regions.size();
  };
  EXPECT_EQ(count(14, 1.0), 9U);
  // The halls at both ends have a single hall beside them, but two rooms as well.
  EXPECT_EQ(count(14, 0.5), 7U);
  EXPECT_EQ(count(14, 0.8), 9U);
  EXPECT_EQ(count(6, 0.5), 9U);
}

}  // namespace
}  // namespace stope::topology
