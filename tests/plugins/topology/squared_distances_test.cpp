#include "plugins/topology/squared_distances.hpp"

#include <gtest/gtest.h>

#include "tests/plugins/topology/test_grids.hpp"

namespace stope::topology {
namespace {

/// Compares with the nearest of all obstacle cells, margin included.
void expect_exact(const OccupancyGrid& grid) {
  const FreeSpace space = make_free_space(grid, {});
  PaddedGrid<std::uint32_t> distances(space.width(), space.height());
  find_squared_distances(space, distances);
  std::vector<Cell> obstacles;
  for (std::int32_t row = -1; row <= space.height(); ++row)
    for (std::int32_t column = -1; column <= space.width(); ++column)
      if (space[space.index(column, row)] & kObstacle) obstacles.push_back({column, row});
  for (std::int32_t row = 0; row < space.height(); ++row) {
    for (std::int32_t column = 0; column < space.width(); ++column) {
      std::int32_t least = INT32_MAX;
      for (const Cell& obstacle : obstacles) {
        const std::int32_t x = obstacle.column - column, y = obstacle.row - row;
        least = std::min(least, x * x + y * y);
      }
      ASSERT_EQ(distances[space.index(column, row)], static_cast<std::uint32_t>(least))
          << "cell " << column << ", " << row;
    }
  }
}

TEST(SquaredDistances, AreExactOnRandomGrids) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    expect_exact(random_grid(37, 29, 0.5, 1, seed));
    expect_exact(random_grid(37, 29, 0.97, 1, seed));
    expect_exact(random_grid(41, 35, 0.6, 5, seed));
    expect_exact(random_grid(23, 140, 0.99, 1, seed));
  }
}

TEST(SquaredDistances, AreExactInEmptyOneCellAndOneRowMaps) {
  expect_exact(random_grid(150, 130, 1.0, 1, 0));
  expect_exact(grid_of({"."}));
  expect_exact(grid_of({"#####", "##.##", "#####"}));
  expect_exact(random_grid(90, 1, 0.9, 1, 1));
  expect_exact(random_grid(1, 90, 0.9, 1, 1));
}

}  // namespace
}  // namespace stope::topology
