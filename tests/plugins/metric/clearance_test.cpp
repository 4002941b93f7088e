#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "plugins/metric/disc_union.hpp"
#include "plugins/metric/obstacle_edges.hpp"
#include "tests/plugins/metric/drawn_grid.hpp"
#include "tests/plugins/metric/drawn_roads.hpp"
#include "tests/plugins/stage_harness.hpp"

extern "C" const stope::StageEntry* stope_stage_Clearance();
extern "C" const stope::StageEntry* stope_stage_Coverage();

namespace stope::metric {
namespace {

double to_nearest_cell(const FreeCells& cells, const Vector2& point) {
  double best = std::min(
      {point.x(), point.y(), cells.frame.width - point.x(), cells.frame.height - point.y()});
  for (std::int32_t row = 0; row < cells.frame.height; ++row)
    for (std::int32_t column = 0; column < cells.frame.width; ++column)
      if (!cells.at(column, row)) {
        const double x = std::max({0.0, column - point.x(), point.x() - column - 1});
        const double y = std::max({0.0, row - point.y(), point.y() - row - 1});
        best = std::min(best, std::hypot(x, y));
      }
  return std::max(0.0, best);
}

TEST(ObstacleEdges, AgreeWithFineSamplesAgainstAllCells) {
  Random random(4);
  for (int round = 0; round < 60; ++round) {
    const OccupancyGrid grid = random_grid(random, 20, 15, 0.04);
    const FreeCells cells = free_cells(grid, {});
    const ObstacleEdges obstacles(cells);
    const Vector2 a(random.uniform(-1, 21), random.uniform(-1, 16));
    const Vector2 b(random.uniform(-1, 21), random.uniform(-1, 16));
    double least = std::numeric_limits<double>::infinity();
    for (int k = 0; k <= 2000; ++k)
      least = std::min(least, to_nearest_cell(cells, a + k / 2000.0 * (b - a)));
    EXPECT_NEAR(obstacles.distance(a, b), least, 0.01);
    EXPECT_NEAR(obstacles.distance(a, a), to_nearest_cell(cells, a), 1e-12);
  }
}

TEST(Clearance, IsTakenBetweenVerticesToo) {
  // A road from left to right, 12 m long, with a post of 1 m beside its middle.
  OccupancyGrid grid = walled(24, 12, 0.5);
  grid.cells[grid.frame.place({12, 3})] = OccupancyGrid::kOccupied;  // 6 to 6.5, 1.5 to 2
  RoadGraph roads = draw_roads({{{3, 3}, {9, 3}}});
  stope::testing::StageHarness stage(stope_stage_Clearance());
  const Measures measures = stage.input("roads", roads).input("grid", grid).apply<Measures>();
  EXPECT_NEAR(value_of(measures, "clearance_min"), 1, 1e-12);
  EXPECT_NEAR(value_of(measures, "clearance_overstated_max"), 4, 1e-12);  // the graph says 5
}

TEST(Clearance, ATurnedGridIsTheSame) {
  OccupancyGrid grid = walled(24, 12, 0.5);
  grid.frame.origin = {10, 20, std::numbers::pi / 2};
  // x of the grid points north: the road runs from (7, 23) to (7, 29), in the middle of the map.
  const RoadGraph roads = draw_roads({{{7, 23}, {7, 29}}});
  const Measures measures = stope::testing::StageHarness(stope_stage_Clearance())
                                .input("roads", roads)
                                .input("grid", grid)
                                .apply<Measures>();
  EXPECT_NEAR(value_of(measures, "clearance_min"), 2.5, 1e-9);
}

TEST(Clearance, InAnObstacleItIsNothingAndOfNothingInfinite) {
  const auto least = [](const RoadGraph& roads) {
    return value_of(stope::testing::StageHarness(stope_stage_Clearance())
                        .input("roads", roads)
                        .input("grid", walled(20, 20))
                        .apply<Measures>(),
                    "clearance_min");
  };
  EXPECT_EQ(least(draw_roads({{{5, 5}, {50, 5}}})), 0);
  EXPECT_EQ(least(draw_roads({{{-5, -5}, {-5, -9}}})), 0);
  EXPECT_EQ(least({}), std::numeric_limits<double>::infinity());
}

TEST(Coverage, OfDiscsIsThatOfTryingAllPoints) {
  Random random(9);
  for (int round = 0; round < 5; ++round) {
    const OccupancyGrid grid = random_grid(random, 40, 40, 0.01);
    const FreeCells cells = free_cells(grid, {});
    const RoadGraph graph = random_roads(random, 4, 3, 40);
    std::vector<std::pair<Vector2, double>> discs;
    for (const RoadEdge& edge : graph.edges) {
      const auto line = graph.polyline(edge);
      for (std::size_t i = 1; i < line.size(); ++i)
        for (int k = 0; k <= 200; ++k) {
          const Vector2 point(line[i - 1].x + k / 200.0 * (line[i].x - line[i - 1].x),
                              line[i - 1].y + k / 200.0 * (line[i].y - line[i - 1].y));
          discs.emplace_back(point, to_nearest_cell(cells, point));
        }
    }
    double expected = 0;
    for (std::int32_t row = 0; row < 40; ++row)
      for (std::int32_t column = 0; column < 40; ++column)
        expected += std::any_of(discs.begin(), discs.end(), [&](const auto& disc) {
          return (Vector2(column + 0.5, row + 0.5) - disc.first).norm() <= disc.second;
        });
    EXPECT_NEAR(static_cast<double>(cells_in_discs(graph, cells)), expected, 0.01 * expected + 2);
  }
}

TEST(Coverage, OfACorridorItsMiddleLineCoversAllButTheCorners) {
  // 100 x 10 m of free space. Discs of 5 m along the middle leave four corners of 25 (1 - pi/4).
  const OccupancyGrid grid = walled(1002, 102, 0.1);
  const Measures measures = stope::testing::StageHarness(stope_stage_Coverage())
                                .input("roads", draw_roads({{{5.1, 5.1}, {95.1, 5.1}}}))
                                .input("grid", grid)
                                .apply<Measures>();
  EXPECT_NEAR(value_of(measures, "coverage"), 1 - 100 * (1 - std::numbers::pi / 4) / 1000, 1e-3);
}

TEST(Coverage, NothingAndRoadsOffTheMapCoverNothing) {
  const auto coverage = [](const RoadGraph& roads) {
    return value_of(stope::testing::StageHarness(stope_stage_Coverage())
                        .input("roads", roads)
                        .input("grid", walled(20, 20))
                        .apply<Measures>(),
                    "coverage");
  };
  EXPECT_EQ(coverage({}), 0);
  EXPECT_EQ(coverage(draw_roads({{{-5.5, -3.5}, {-9.5, 70.5}}})), 0);
  EXPECT_EQ(coverage(draw_roads({{{30, 5}, {1e9, 5}}})), 0);
}

}  // namespace
}  // namespace stope::metric
