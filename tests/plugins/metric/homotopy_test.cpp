#include <gtest/gtest.h>

#include <cmath>
#include <deque>

#include "plugins/metric/space_pieces.hpp"
#include "tests/plugins/metric/drawn_grid.hpp"
#include "tests/plugins/metric/drawn_roads.hpp"
#include "tests/plugins/stage_harness.hpp"

extern "C" const stope::StageEntry* stope_stage_Homotopy();

namespace stope::metric {
namespace {

using stope::testing::error_of;

// The connected cells with the value of a place, in a grid with a border of obstacles.
std::vector<std::size_t> flood(const std::vector<std::vector<int>>& grid, std::size_t row,
                               std::size_t column, std::vector<std::vector<int>>& seen) {
  const int value = grid[row][column];
  std::vector<std::size_t> cells;
  std::deque<std::pair<std::size_t, std::size_t>> open{{row, column}};
  seen[row][column] = 1;
  while (!open.empty()) {
    const auto [r, c] = open.front();
    open.pop_front();
    cells.push_back(r * grid[0].size() + c);
    for (std::size_t y = r == 0 ? 0 : r - 1; y < std::min(r + 2, grid.size()); ++y) {
      for (std::size_t x = c == 0 ? 0 : c - 1; x < std::min(c + 2, grid[0].size()); ++x) {
        if (value == 0 && y != r && x != c) continue;  // obstacles: not over corners
        if (grid[y][x] != value || seen[y][x]) continue;
        seen[y][x] = 1;
        open.emplace_back(y, x);
      }
    }
  }
  return cells;
}

Betti by_flooding(const OccupancyGrid& grid) {
  const auto width = static_cast<std::size_t>(grid.frame.width);
  const auto height = static_cast<std::size_t>(grid.frame.height);
  std::vector<std::vector<int>> free(height + 2, std::vector<int>(width + 2)), seen = free;
  for (std::size_t r = 0; r < height; ++r)
    for (std::size_t c = 0; c < width; ++c)
      free[r + 1][c + 1] = grid.cells[r * width + c] == OccupancyGrid::kFree ? 1 : 0;
  Betti betti;
  for (std::size_t r = 0; r < free.size(); ++r) {
    for (std::size_t c = 0; c < free[0].size(); ++c) {
      if (seen[r][c]) continue;
      flood(free, r, c, seen);
      ++(free[r][c] ? betti.pieces : betti.holes);
    }
  }
  --betti.holes;  // the outside
  return betti;
}

TEST(BettiOfSpace, IsThatOfFlooding) {
  Random random(1);
  for (int round = 0; round < 200; ++round) {
    const OccupancyGrid grid =
        random_grid(random, 3 + static_cast<int>(random.below(15)),
                    3 + static_cast<int>(random.below(15)), random.uniform(0.2, 0.8));
    const Betti expected = by_flooding(grid), betti = betti_of_space(free_cells(grid, {}), 0, 0);
    EXPECT_EQ(betti.pieces, expected.pieces);
    EXPECT_EQ(betti.holes, expected.holes);
  }
}

// A ring wall of 24 cells that encloses a yard of 25 cells with a post in it, and a second post.
const OccupancyGrid kNested = draw_grid({".............",  //
                                         ".#######.....",  //
                                         ".#.....#.....",  //
                                         ".#.....#.....",  //
                                         ".#..#..#..#..",  //
                                         ".#.....#.....",  //
                                         ".#.....#.....",  //
                                         ".#######.....",  //
                                         "............."});

TEST(BettiOfSpace, AHolesAreaIsWhatItEncloses) {
  const FreeCells cells = free_cells(kNested, {});
  const auto counted = [&](double hole, double piece) {
    const Betti betti = betti_of_space(cells, hole, piece);
    return std::pair(betti.pieces, betti.holes);
  };
  EXPECT_EQ(counted(0, 0), std::pair(std::size_t{2}, std::size_t{3}));
  EXPECT_EQ(counted(2, 0), std::pair(std::size_t{2}, std::size_t{1}));
  EXPECT_EQ(counted(49, 0), std::pair(std::size_t{2}, std::size_t{1}));
  EXPECT_EQ(counted(50, 0), std::pair(std::size_t{1}, std::size_t{0}));
  EXPECT_EQ(counted(0, 25), std::pair(std::size_t{1}, std::size_t{2}));
}

TEST(BettiOfGraph, CountsPiecesAndCycles) {
  RoadGraph graph = draw_roads({{{0, 0}, {9, 0}, {9, 9}, {0, 0}},
                                {{20, 0}, {30, 0}},
                                {{20, 0}, {25, 5}, {30, 0}},
                                {{20, 0}, {25, 9}, {30, 0}}});
  graph.nodes.push_back({9, 99, 99, 0});
  EXPECT_EQ(betti_of_graph(graph).pieces, 3U);
  EXPECT_EQ(betti_of_graph(graph).holes, 3U);
  EXPECT_EQ(betti_of_graph({}).pieces, 0U);
}

TEST(Homotopy, ComparesGraphAndFreeSpace) {
  stope::testing::StageHarness stage(stope_stage_Homotopy());
  stage.input("grid", kNested).set("min_hole_area", 2.0);
  const Measures right =
      stage
          .input("roads", draw_roads({{{0.5, 0.5}, {8.5, 0.5}, {8.5, 8.5}, {0.5, 8.5}, {0.5, 0.5}},
                                      {{3, 3}, {4, 3}}}))
          .apply<Measures>();
  EXPECT_EQ(value_of(right, "delta_beta0"), 0);
  EXPECT_EQ(value_of(right, "delta_beta1"), 0);
  EXPECT_EQ(value_of(right, "free_beta1"), 1);
  const Measures none = stage.input("roads", RoadGraph{}).apply<Measures>();
  EXPECT_EQ(value_of(none, "delta_beta0"), 2);
  EXPECT_EQ(value_of(none, "delta_beta1"), 1);
}

TEST(Homotopy, RefusesGridsThatAreNotWhole) {
  const auto sentence = [](const OccupancyGrid& grid) {
    return error_of([&] {
      stope::testing::StageHarness(stope_stage_Homotopy())
          .input("roads", RoadGraph{})
          .input("grid", grid)
          .apply<Measures>();
    });
  };
  OccupancyGrid grid = kNested;
  grid.frame.resolution = 0;
  EXPECT_NE(sentence(grid).find("resolution of 0 m"), std::string::npos);
  grid = kNested;
  grid.cells.pop_back();
  EXPECT_NE(sentence(grid).find("holds 116"), std::string::npos);
  EXPECT_NE(sentence({}).find("is empty"), std::string::npos);
  EXPECT_NE(sentence(draw_grid({"##", "?#"})).find("no free cell"), std::string::npos);
  grid = kNested;
  grid.frame.origin.x = std::nan("");
  EXPECT_NE(sentence(grid).find("not a place"), std::string::npos);
}

}  // namespace
}  // namespace stope::metric
