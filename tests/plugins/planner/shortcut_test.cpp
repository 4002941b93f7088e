#include "plugins/planner/shortcut.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "plugins/planner/path_sampling.hpp"
#include "plugins/planner/plan.hpp"
#include "stope/random.hpp"
#include "tests/plugins/planner/test_roads.hpp"

namespace stope::planner {
namespace {

OccupancyGrid open_ground() {
  OccupancyGrid grid;
  grid.frame = {60, 50, 1.0, {}};
  grid.cells.assign(grid.frame.size(), OccupancyGrid::kFree);
  return grid;
}

void block(OccupancyGrid& grid, int left, int bottom, int right, int top) {
  for (int row = bottom; row < top; ++row)
    for (int column = left; column < right; ++column)
      grid.cells[grid.frame.place({column, row})] = OccupancyGrid::kOccupied;
}

double length(const std::vector<Vector2>& points) {
  double sum = 0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += (points[i] - points[i - 1]).norm();
  return sum;
}

TEST(Shortcut, RunsTautRoundACorner) {
  OccupancyGrid grid = open_ground();
  block(grid, 20, 0, 40, 30);
  const std::vector<RoadVertex> road{
      {10.5, 10.5, 0, 9}, {10.5, 40.5, 0, 9}, {49.5, 40.5, 0, 9}, {49.5, 10.5, 0, 9}};
  const auto points = shortcut_along(DrivableGrid(grid), {road}, 0);
  ASSERT_TRUE(points);
  // Cells beside the corners: (19, 30) and (40, 30).
  const double taut = 2 * std::hypot(19.5 - 10.5, 30.5 - 10.5) + 21;
  EXPECT_GE(length(*points), taut - 1e-9);
  EXPECT_LT(length(*points), 1.01 * taut);
  for (std::size_t i = 1; i < points->size(); ++i)
    EXPECT_TRUE(line_clear(DrivableGrid(grid), (*points)[i - 1], (*points)[i]));
}

TEST(Shortcut, KeepsTheClearanceAsked) {
  OccupancyGrid grid = open_ground();
  block(grid, 20, 0, 40, 30);
  const std::vector<RoadVertex> road{
      {10.5, 10.5, 0, 9}, {10.5, 40.5, 0, 9}, {49.5, 40.5, 0, 9}, {49.5, 10.5, 0, 9}};
  const DrivableGrid drivable(grid);
  const auto points = shortcut_along(drivable, {road}, 5);
  ASSERT_TRUE(points);
  for (std::size_t i = 1; i < points->size(); ++i) {
    for (double f = 0; f <= 1; f += 0.05) {
      const Vector2 at = (*points)[i - 1] + f * ((*points)[i] - (*points)[i - 1]);
      // Half a cell's diagonal, as cells are asked at their centres.
      EXPECT_GE(drivable.clearance(at, 10), 5 - 0.71);
    }
  }
}

TEST(Shortcut, LinesDoNotSlipBetweenCellsThatTouchAtACorner) {
  OccupancyGrid grid = open_ground();
  block(grid, 10, 10, 11, 11);
  block(grid, 11, 11, 12, 12);
  const DrivableGrid drivable(grid);
  EXPECT_FALSE(line_clear(drivable, {10.5, 11.5}, {11.5, 10.5}));
  EXPECT_FALSE(line_clear(drivable, {9.5, 10.5}, {10.5, 9.5 + 1e-12}));  // cuts a corner
  EXPECT_TRUE(line_clear(drivable, {9.5, 9.5}, {13.5, 9.5}));
}

// Against a line looked at every hundredth of a cell.
TEST(Shortcut, LinesOfSightSeeWhatFineSamplingSees) {
  Random random(5);
  OccupancyGrid grid = open_ground();
  for (auto& cell : grid.cells) cell = random.below(20) == 0 ? 254 : 0;
  const DrivableGrid drivable(grid);
  int clear = 0, blocked = 0;
  for (int trial = 0; trial < 2000; ++trial) {
    const Vector2 a(random.uniform(0, 60), random.uniform(0, 50));
    const Vector2 b = a + Vector2(random.uniform(-12, 12), random.uniform(-12, 12));
    if (!grid.frame.cell_at(b.x(), b.y())) continue;
    bool sampled = true;
    for (int i = 0; i <= 2000 && sampled; ++i) {
      const Vector2 at = a + (i / 2000.0) * (b - a);
      sampled = drivable.ground_at(at) == Ground::kFree;
    }
    const bool seen = line_clear(drivable, a, b);
    ++(seen ? clear : blocked);
    if (seen) {
      EXPECT_TRUE(sampled);
    }
  }
  EXPECT_GT(clear, 300);
  EXPECT_GT(blocked, 300);
}

TEST(Shortcut, PlansTheTautWayAlsoWhereAnotherRoadIsShorterOnceTaut) {
  OccupancyGrid grid = open_ground();
  block(grid, 20, 20, 40, 30);
  RoadGraph graph;
  graph.nodes = {{1, 5, 25, 0}, {2, 55, 25, 0}};
  add_road(graph, 0, 1, {{15, 33}, {45, 33}}, 3);  // shorter by road
  add_road(graph, 0, 1, {{15, 10}, {45, 10}}, 10);
  PlanRequest request;
  request.start = {5.5, 18.5};
  request.goal = {54.5, 18.5};
  request.shortcut = true;
  const Path path = plan_path(graph, &grid, request, [](std::string_view) {});
  EXPECT_NEAR(path.length, 49, 1e-9);  // straight below the block
  const auto cell = grid.frame.cell_at(path.points[25].x, path.points[25].y);
  EXPECT_EQ(cell->row, 18);
}

}  // namespace
}  // namespace stope::planner
