#include "plugins/metric/medial_axis.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "plugins/metric/nearest_obstacle.hpp"
#include "tests/plugins/metric/drawn_grid.hpp"
#include "tests/plugins/metric/drawn_roads.hpp"
#include "tests/plugins/stage_harness.hpp"

extern "C" const stope::StageEntry* stope_stage_MedialDistance();

namespace stope::metric {
namespace {

TEST(NearestObstacle, IsThatOfTryingAll) {
  Random random(2);
  for (int round = 0; round < 60; ++round) {
    const OccupancyGrid grid =
        random_grid(random, 1 + static_cast<int>(random.below(18)),
                    1 + static_cast<int>(random.below(18)), random.uniform(0, 0.4));
    if (std::find(grid.cells.begin(), grid.cells.end(), 0) == grid.cells.end()) continue;
    const FreeCells cells = free_cells(grid, {});
    const NearestObstacle nearest(cells);
    const auto square = [](Cell a, Cell b) {
      return (a.column - b.column) * (a.column - b.column) + (a.row - b.row) * (a.row - b.row);
    };
    for (std::int32_t row = 0; row < grid.frame.height; ++row) {
      for (std::int32_t column = 0; column < grid.frame.width; ++column) {
        const Cell here{column, row}, found = nearest.of(here);
        int best = 1 << 30;
        for (std::int32_t r = -1; r <= grid.frame.height; ++r)
          for (std::int32_t c = -1; c <= grid.frame.width; ++c)
            if (!cells.at(c, r)) best = std::min(best, square(here, {c, r}));
        EXPECT_FALSE(cells.at(found.column, found.row));
        EXPECT_EQ(square(here, found), best);
      }
    }
  }
}

TEST(MedialAxis, OfARectangleIsItsMiddleLine) {
  // 60 x 21 m free: the axis runs at y = 11.5 between the ends' diagonals, which see 90 degrees.
  const auto axis = medial_axis(free_cells(walled(62, 23), {}), 1.75, 2);
  ASSERT_GT(axis.size(), 30U);
  for (const Vector2& point : axis) {
    EXPECT_NEAR(point.y(), 11.5, 0.51);
    EXPECT_GT(point.x(), 10);
    EXPECT_LT(point.x(), 52);
  }
  // With a smaller angle the diagonals are there as well.
  EXPECT_GT(medial_axis(free_cells(walled(62, 23), {}), 1.2, 2).size(), axis.size() + 40);
}

TEST(MedialDistance, OfTheMiddleLineIsSmallAndOfAParallelOneItsDistance) {
  const OccupancyGrid grid = walled(120, 42, 0.5);  // 59 x 20 m, middle at y = 10.5
  const auto measure = [&](double y) {
    return stope::testing::StageHarness(stope_stage_MedialDistance())
        .input("roads", draw_roads({{{10.5, y}, {49.5, y}}}))
        .input("grid", grid)
        .apply<Measures>();
  };
  EXPECT_LE(value_of(measure(10.5), "medial_hausdorff"), 0.5);
  EXPECT_NEAR(value_of(measure(13.5), "medial_mean"), 3, 0.15);
  EXPECT_NEAR(value_of(measure(13.5), "graph_to_axis_max"), 3, 0.3);
}

TEST(MedialDistance, WhatTheGraphLacksIsSeenFromTheAxis) {
  const Measures measures = stope::testing::StageHarness(stope_stage_MedialDistance())
                                .input("roads", draw_roads({{{10.5, 10.5}, {29.5, 10.5}}}))
                                .input("grid", walled(120, 42, 0.5))
                                .apply<Measures>();
  EXPECT_LE(value_of(measures, "graph_to_axis_max"), 0.5);
  EXPECT_NEAR(value_of(measures, "axis_to_graph_max"), 20, 1);
  EXPECT_NEAR(value_of(measures, "medial_hausdorff"), 20, 1);
}

TEST(MedialDistance, OfNothingIsInfiniteAndWithoutAnAxisRefused) {
  stope::testing::StageHarness stage(stope_stage_MedialDistance());
  stage.input("grid", walled(120, 42, 0.5)).input("roads", RoadGraph{});
  EXPECT_EQ(value_of(stage.apply<Measures>(), "medial_mean"),
            std::numeric_limits<double>::infinity());
  stage.set("min_clearance", 30.0);
  EXPECT_NE(stope::testing::error_of([&] { stage.apply<Measures>(); }).find("no medial axis"),
            std::string::npos);
}

}  // namespace
}  // namespace stope::metric
