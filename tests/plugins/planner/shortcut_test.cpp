#include "plugins/planner/shortcut.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

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

/// All ground open, the whole grid looked at.
std::optional<std::vector<Vector2>> shortened(const OccupancyGrid& grid,
                                              const std::vector<RoadVertex>& road,
                                              double min_clearance) {
  return shortcut(DrivableGrid(grid), RoadGround(), {0, 0, grid.frame.width, grid.frame.height},
                  road, min_clearance);
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
  const auto points = shortened(grid, road, 0);
  ASSERT_TRUE(points);
  // Cells beside the corners: (19, 30) and (40, 30).
  const double taut = 2 * std::hypot(19.5 - 10.5, 30.5 - 10.5) + 21;
  EXPECT_GE(length(*points), taut - 1e-9);
  EXPECT_LT(length(*points), 1.01 * taut);
  for (std::size_t i = 1; i < points->size(); ++i)
    EXPECT_TRUE(DrivableGrid(grid).line_free((*points)[i - 1], (*points)[i]));
}

TEST(Shortcut, KeepsTheClearanceAsked) {
  OccupancyGrid grid = open_ground();
  block(grid, 20, 0, 40, 30);
  const std::vector<RoadVertex> road{
      {10.5, 10.5, 0, 9}, {10.5, 40.5, 0, 9}, {49.5, 40.5, 0, 9}, {49.5, 10.5, 0, 9}};
  const DrivableGrid drivable(grid);
  const auto points = shortened(grid, road, 5);
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
  EXPECT_FALSE(drivable.line_free({10.5, 11.5}, {11.5, 10.5}));
  EXPECT_FALSE(drivable.line_free({9.5, 10.5}, {10.5, 9.5 + 1e-12}));  // cuts a corner
  EXPECT_TRUE(drivable.line_free({9.5, 9.5}, {13.5, 9.5}));
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
    const bool seen = drivable.line_free(a, b);
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

Path planned(const RoadGraph& graph, const OccupancyGrid& grid, Vector2 start, Vector2 goal,
             const std::function<void(PlanRequest&)>& change = {}) {
  PlanRequest request;
  request.start = {start.x(), start.y()};
  request.goal = {goal.x(), goal.y()};
  request.shortcut = true;
  request.step = 0.1;
  if (change) change(request);
  return plan_path(graph, &grid, request, [](std::string_view) {});
}

/// Length of the shortest way over cells that cuts no corner, by relaxing all cells until nothing
/// changes.
double shortest_over_cells(const OccupancyGrid& grid, Cell from, Cell to) {
  const DrivableGrid ground(grid);
  std::vector<double> metres(grid.frame.size(), HUGE_VAL);
  metres[grid.frame.place(from)] = 0;
  for (bool changed = true; changed;) {
    changed = false;
    for (int row = 0; row < grid.frame.height; ++row) {
      for (int column = 0; column < grid.frame.width; ++column) {
        if (!ground.free({column, row})) continue;
        for (int dy = -1; dy <= 1; ++dy) {
          for (int dx = -1; dx <= 1; ++dx) {
            const Cell next{column + dx, row + dy};
            if (!ground.free(next) || !ground.free({column + dx, row}) ||
                !ground.free({column, row + dy}))
              continue;
            const double further = metres[grid.frame.place({column, row})] + std::hypot(dx, dy);
            if (further >= metres[grid.frame.place(next)] - 1e-12) continue;
            metres[grid.frame.place(next)] = further;
            changed = true;
          }
        }
      }
    }
  }
  return metres[grid.frame.place(to)];
}

// On random ground, with a road whose line runs through obstacles: no way over cells is shorter,
// and no point of the way lies in an obstacle. Once such a road was returned as it was.
TEST(Shortcut, NoWayOverCellsIsShorterAndNoneTouchesAnObstacle) {
  Random random(11);
  int planned_ways = 0;
  for (int trial = 0; trial < 40; ++trial) {
    OccupancyGrid grid = open_ground();
    for (auto& cell : grid.cells) cell = random.below(4) == 0 ? 254 : 0;
    const Cell from{2, 25}, to{57, 25};
    grid.cells[grid.frame.place(from)] = grid.cells[grid.frame.place(to)] = 0;
    const double truth = shortest_over_cells(grid, from, to);
    if (truth == HUGE_VAL) continue;
    RoadGraph graph;
    graph.nodes = {{1, 2.5, 25.5, 0}, {2, 57.5, 25.5, 0}};
    add_road(graph, 0, 1, {{30, 27}}, 0);
    const Path path = planned(graph, grid, {2.5, 25.5}, {57.5, 25.5},
                              [](PlanRequest& request) { request.avoid_obstructed = false; });
    ++planned_ways;
    EXPECT_LE(path.length, truth + 1e-6);
    EXPECT_GE(path.length, 55 - 1e-9);
    for (const PathPoint& point : path.points)
      ASSERT_EQ(DrivableGrid(grid).ground_at({point.x, point.y}), Ground::kFree)
          << "trial " << trial << " at " << point.x << ", " << point.y;
  }
  EXPECT_GT(planned_ways, 20);
}

/// Two roads side by side over open ground, joined at both ends by short ones; the lower one lies
/// on the straight way. Roads: 0 lower, 1 upper, 2 and 3 the short ones.
RoadGraph two_lanes() {
  RoadGraph graph;
  graph.nodes = {{1, 5.5, 15.5, 0}, {2, 55.5, 15.5, 0}, {3, 5.5, 35.5, 0}, {4, 55.5, 35.5, 0}};
  add_road(graph, 0, 1, {}, 10);
  add_road(graph, 2, 3, {}, 10);
  add_road(graph, 0, 2, {}, 10);
  add_road(graph, 1, 3, {}, 10);
  return graph;
}

/// How far a path comes into the rows below the line that both lanes are equally far from, between
/// columns that no other road is nearer to.
double metres_below(const Path& path, double left, double right) {
  double metres = 0;
  for (const PathPoint& point : path.points)
    if (point.x > left && point.x < right) metres = std::max(metres, 25.5 - point.y);
  return metres;
}

TEST(Shortcut, GroundOfAClosedRoadStaysClosed) {
  const OccupancyGrid grid = open_ground();
  RoadGraph graph = two_lanes();
  const Vector2 start(5.5, 15.5), goal(55.5, 15.5);
  EXPECT_NEAR(planned(graph, grid, start, goal).length, 50, 1e-9);
  const auto close = [&](PlanRequest& request) {
    request.changes.closed_roads = {std::to_string(graph.edges[0].id)};
  };
  const Path round = planned(graph, grid, start, goal, close);
  // Nothing in the grid bars the way; only the rule keeps it half a lane away: up along the
  // diagonal to where the upper road's ground begins, along it, and down again.
  EXPECT_GT(round.length, 50 + 5);
  EXPECT_LT(round.length, 90);
  EXPECT_LT(metres_below(round, 17, 44), 1);
  graph.edges[0].closed = 1;
  const Path closed = planned(graph, grid, start, goal);
  EXPECT_NEAR(closed.length, round.length, 1e-9);
}

TEST(Shortcut, DoesNotGoAgainstAOneWayRoad) {
  const OccupancyGrid grid = open_ground();
  RoadGraph graph = two_lanes();
  graph.edges[0].direction = RoadDirection::kForward;
  const Vector2 west(5.5, 15.5), east(55.5, 15.5);
  EXPECT_NEAR(planned(graph, grid, west, east).length, 50, 1e-9);
  const Path back = planned(graph, grid, east, west);
  EXPECT_GT(back.length, 50 + 5);
  EXPECT_LT(metres_below(back, 17, 44), 1);
}

TEST(Shortcut, DoesNotPassAClosedPlaceOnItsRoadsGround) {
  const OccupancyGrid grid = open_ground();
  const RoadGraph graph = two_lanes();
  const auto cut = [](PlanRequest& request) { request.changes.closed_places = {30.5, 15.5}; };
  const Path round = planned(graph, grid, {5.5, 15.5}, {55.5, 15.5}, cut);
  // Across the upper road's ground at the place, but no farther round than that.
  EXPECT_LT(metres_below(round, 29.5, 31.5), 1);
  EXPECT_NEAR(round.length, 2 * std::hypot(25, 10), 1);
  // Up to the place it is driven from either side.
  EXPECT_NEAR(planned(graph, grid, {5.5, 15.5}, {29.5, 15.5}, cut).length, 24, 1e-9);
  EXPECT_NEAR(planned(graph, grid, {55.5, 15.5}, {31.5, 15.5}, cut).length, 24, 1e-9);
}

TEST(Shortcut, SlowGroundCostsAsMuchMore) {
  const OccupancyGrid grid = open_ground();
  const RoadGraph graph = two_lanes();
  const auto slowed = [&](double factor) {
    return planned(graph, grid, {5.5, 15.5}, {55.5, 15.5}, [=](PlanRequest& request) {
      request.changes.slow_places = {30.5, 15.5, factor};
    });
  };
  EXPECT_NEAR(slowed(1.1).length, 50, 1e-6);  // the way round is dearer
  EXPECT_LT(metres_below(slowed(10), 17, 44), 1.5);
}

// Each free cell's road by brute force over all pieces of all roads, on ground without walls.
TEST(RoadGround, CellsBelongToTheNearestRoad) {
  const OccupancyGrid grid = open_ground();
  RoadGraph graph;
  graph.nodes = {{1, 3, 4, 0}, {2, 50, 9, 0}, {3, 20, 45, 0}};
  add_road(graph, 0, 1, {{12, 20}, {25, 22}, {33, 3}}, 5);
  add_road(graph, 1, 2, {{55, 30}, {40, 31}}, 5);
  add_road(graph, 2, 0, {{2, 30}}, 5);
  for (std::uint32_t closed = 0; closed < 3; ++closed) {
    graph.edges[0].closed = graph.edges[1].closed = graph.edges[2].closed = 0;
    graph.edges[closed].closed = 1;
    const RoadNetwork network(graph, {});
    const DrivableGrid drivable(grid);
    const RoadChanges none;
    const RoadGround ground(drivable, network, none, {0, 0, 60, 50}, {});
    int wrong = 0;
    for (int row = 0; row < 50; ++row) {
      for (int column = 0; column < 59; ++column) {
        const Vector2 centre(column + 1.5, row + 0.5);
        double nearest[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL};
        for (std::uint32_t e = 0; e < 3; ++e) {
          const auto line = graph.polyline(graph.edges[e]);
          for (std::size_t i = 1; i < line.size(); ++i) {
            for (double f = 0; f <= 1; f += 0.001) {
              const Vector2 at(line[i - 1].x + f * (line[i].x - line[i - 1].x),
                               line[i - 1].y + f * (line[i].y - line[i - 1].y));
              nearest[e] = std::min(nearest[e], (at - centre).norm());
            }
          }
        }
        const double open = std::min(nearest[(closed + 1) % 3], nearest[(closed + 2) % 3]);
        if (std::abs(open - nearest[closed]) < 0.1) continue;  // at the border either is right
        wrong +=
            ground.passable({column, row}, {column + 1, row}, {1, 0}) == (nearest[closed] < open)
                ? 1
                : 0;
      }
    }
    EXPECT_EQ(wrong, 0) << "road " << closed;
  }
}

}  // namespace
}  // namespace stope::planner
