#include "plugins/topology/nearest_outline.hpp"

#include <gtest/gtest.h>

#include "tests/plugins/topology/test_grids.hpp"

namespace stope::topology {
namespace {

struct Transformed {
  explicit Transformed(const OccupancyGrid& grid)
      : space(make_free_space(grid, {})),
        edges(space.width(), space.height()),
        outlines(trace_outlines(space, edges, 0, 8)) {
    find_nearest_outline(space, outlines, edges);
  }
  FreeSpace space;
  EdgeGrid edges;
  Outlines outlines;
};

/// The nearest obstacle cell, margin included, by looking at all of them from west to east and each
/// column from below.
std::pair<std::int64_t, Outlines::Place> brute_force(const FreeSpace& space, std::int32_t column,
                                                     std::int32_t row) {
  std::pair<std::int64_t, Outlines::Place> nearest{std::numeric_limits<std::int64_t>::max(), {}};
  for (std::int32_t x = -1; x <= space.width(); ++x) {
    for (std::int32_t y = -1; y <= space.height(); ++y) {
      const std::int64_t distance = (x - column) * (x - column) + (y - row) * (y - row);
      if ((space[space.index(x, y)] & kObstacle) && distance < nearest.first)
        nearest = {distance, {x, y}};
    }
  }
  return nearest;
}

void expect_exact(const OccupancyGrid& grid) {
  const Transformed map(grid);
  for (std::int32_t row = 0; row < map.space.height(); ++row) {
    for (std::int32_t column = 0; column < map.space.width(); ++column) {
      const CellIndex cell = map.space.index(column, row);
      if (map.space[cell] & kObstacle) continue;
      const OutlineEdge edge = map.edges[cell];
      const auto [distance, place] = brute_force(map.space, column, row);
      ASSERT_EQ(squared_distance(map.edges, map.outlines, cell, edge), distance)
          << "cell " << column << ", " << row;
      const Outlines::Place seen = map.outlines.place[static_cast<std::size_t>(edge)];
      ASSERT_EQ(std::pair(seen.column, seen.row), std::pair(place.column, place.row))
          << "cell " << column << ", " << row;
    }
  }
}

TEST(NearestOutline, IsExactOnRandomGrids) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    expect_exact(random_grid(23, 31, 0.3 + 0.017 * static_cast<double>(seed), 1, seed));
    expect_exact(random_grid(37, 29, 0.97, 1, seed));
    expect_exact(random_grid(41, 35, 0.6, 5, seed));
  }
}

TEST(NearestOutline, IsExactAcrossBandsOfRows) {
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    for (const std::int32_t height : {63, 64, 65, 129, 200}) {
      expect_exact(random_grid(23, height, 0.99, 1, seed));
      expect_exact(random_grid(29, height, 0.6, 7, seed));
    }
  }
  expect_exact(random_grid(17, 197, 1.0, 1, 1));
  expect_exact(random_grid(1, 197, 0.99, 1, 1));
}

TEST(NearestOutline, SeesTheEdgeOfTheMapAsAnObstacle) {
  expect_exact(grid_of({".......", ".......", ".......", "......."}));
  expect_exact(grid_of({"."}));
  expect_exact(grid_of({"....."}));
  expect_exact(grid_of({".", ".", "."}));
}

TEST(NearestOutline, NamesTheSideThatFacesTheCell) {
  // A wall one cell thick: what lies left of it must not see its right side.
  const Transformed map(grid_of({".....", "..#..", "..#..", "..#..", "....."}));
  const auto& sides =
      map.outlines.sides[static_cast<std::size_t>(map.edges[map.space.index(2, 2)])];
  EXPECT_EQ(map.edges[map.space.index(1, 2)], sides[kWest]);
  EXPECT_EQ(map.edges[map.space.index(3, 2)], sides[kEast]);
}

TEST(Outlines, AreWalkedOnceAndWhole) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const Transformed map(random_grid(25, 19, 0.5, 1 + static_cast<int>(seed % 3), seed));
    std::int32_t sides = 0, walked = 0;
    for (std::int32_t row = -1; row <= map.space.height(); ++row)
      for (std::int32_t column = -1; column <= map.space.width(); ++column)
        for (const auto& [dx, dy] : {std::pair{1, 0}, {0, 1}, {-1, 0}, {0, -1}})
          if (column + dx >= 0 && row + dy >= 0 && column + dx < map.space.width() &&
              row + dy < map.space.height())
            sides += (map.space[map.space.index(column, row)] & kObstacle) &&
                     !(map.space[map.space.index(column + dx, row + dy)] & kObstacle);
    for (const Outline& outline : map.outlines.list) walked += outline.count;
    EXPECT_EQ(walked, sides);
  }
}

TEST(Outlines, ForgetSmallObstacles) {
  const OccupancyGrid grid = grid_of({"..........",  //
                                      ".##....#..",  //
                                      ".##.......",  //
                                      "....###...",  //
                                      "....#.#...",  //
                                      "....###...",  //
                                      ".........."});
  FreeSpace space = make_free_space(grid, {});
  EdgeGrid edges(space.width(), space.height());
  const auto count = [&](double least_area) {
    FreeSpace copy = make_free_space(grid, {});
    return trace_outlines(copy, edges, least_area, 3).list.size();
  };
  EXPECT_EQ(count(0), 5U);  // the outside, three obstacles, the pocket in the third
  EXPECT_EQ(count(2), 4U);  // without the single cell
  EXPECT_EQ(count(5), 3U);  // without the square of four; the ring encloses nine
  EXPECT_EQ(count(10), 1U);
}

}  // namespace
}  // namespace stope::topology
