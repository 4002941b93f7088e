#include <gtest/gtest.h>

#include <cmath>

#include "tests/plugins/planner/drawn_ground.hpp"
#include "tests/plugins/planner/planner_stage.hpp"
#include "tests/plugins/planner/test_roads.hpp"

extern "C" const stope::StageEntry* stope_stage_AStar();

namespace stope::planner {
namespace {

using stope::testing::error_of;
using stope::testing::StageHarness;

// A road along y = 10 from x = 5 to 55, then up to (55, 40).
RoadGraph bent_road() {
  RoadGraph graph;
  graph.nodes = {{1, 5, 10, 0}, {2, 55, 10, 0}, {3, 55, 40, 0}};
  add_road(graph, 0, 1);
  add_road(graph, 1, 2);
  return graph;
}

StageHarness planner(RoadGraph graph, const Numbers& start, const Numbers& goal) {
  return planner_stage(stope_stage_AStar(), std::move(graph), start, goal);
}

// 60 x 50 m.
OccupancyGrid open_ground() { return free_ground(120, 100); }

void expect_free(const OccupancyGrid& grid, const Path& path) {
  for (const PathPoint& point : path.points) {
    const auto cell = grid.frame.cell_at(point.x, point.y);
    ASSERT_TRUE(cell);
    EXPECT_EQ(grid.cells[grid.frame.place(*cell)], OccupancyGrid::kFree)
        << point.x << " " << point.y;
  }
}

TEST(AStar, DrivesFromStartToGoalByTheMiddlesOfTheEdges) {
  const Path path = planner(bent_road(), {20, 13}, {50, 30}).apply<Path>();
  EXPECT_NEAR(path.length, 3 + 35 + 20 + 5, 1e-9);
  EXPECT_EQ(path.edges, (std::vector<std::uint64_t>{1000, 1001}));
  EXPECT_EQ(path.points.front().x, 20);
  EXPECT_EQ(path.points.back().y, 30);
  const PathPoint& middle = path.points[20];
  EXPECT_NEAR(middle.y, 10, 1e-9);
  EXPECT_NEAR(middle.yaw, 0, 1e-9);
  EXPECT_EQ(middle.clearance, 5);
}

TEST(AStar, WithoutStartAndGoalItJoinsTheFarEnds) {
  auto stage = planner(bent_road(), {}, {});
  const Path path = stage.apply<Path>();
  EXPECT_NEAR(path.length, 80, 1e-9);
  ASSERT_EQ(stage.context().sentences.size(), 3U);
  EXPECT_NE(stage.context().sentences[0].find("no start is given"), std::string::npos);
  EXPECT_NEAR(planner(bent_road(), {50, 10}, {}).apply<Path>().length, 45, 1e-9);
  EXPECT_NEAR(planner(bent_road(), {}, {50, 10}).apply<Path>().length, 45, 1e-9);
}

TEST(AStar, TheLinkRunsRoundAnObstacle) {
  OccupancyGrid grid = open_ground();
  fill(grid, 10, 14, 60, 16, OccupancyGrid::kOccupied);  // between the start and the road
  RoadGraph graph = bent_road();
  graph.edges.pop_back();
  auto stage = planner(graph, {25, 20}, {50, 10});
  const Path path = stage.input("grid", grid).set("step", 0.25).apply<Path>();
  expect_free(grid, path);
  EXPECT_EQ(path.points.front().x, 25);
  // Round the left end of the obstacle, (10, 16) to (10, 14), down to the road and along it.
  EXPECT_GT(path.length, std::hypot(15, 4) + 2 + std::hypot(40, 4));
  EXPECT_LT(path.length, std::hypot(15, 4) + 2 + 4 + 40 + 2);
}

TEST(AStar, TakesARoadItSeesBeforeANearerOneBehindAWall) {
  RoadGraph graph;
  graph.nodes = {{1, 5, 10, 0}, {2, 55, 10, 0}, {3, 5, 30, 0}, {4, 55, 30, 0}};
  add_road(graph, 0, 1);
  add_road(graph, 2, 3);
  add_road(graph, 1, 3);
  OccupancyGrid grid = open_ground();
  fill(grid, 0, 14, 52, 16, OccupancyGrid::kOccupied);
  const Path path = planner(graph, {20, 18}, {50, 30}).input("grid", grid).apply<Path>();
  EXPECT_EQ(path.edges, (std::vector<std::uint64_t>{1001}));
  expect_free(grid, path);
}

TEST(AStar, NamesTheNearestReachablePlace) {
  OccupancyGrid grid = open_ground();
  fill(grid, 10, 20, 20, 30, OccupancyGrid::kOccupied);
  fill(grid, 30, 20, 40, 30, OccupancyGrid::kUnknown);
  const auto sentence = [&](Numbers start, Numbers goal) {
    return error_of([&] { planner(bent_road(), start, goal).input("grid", grid).apply<Path>(); });
  };
  EXPECT_EQ(sentence({-10, 10}, {50, 10}),
            "the start (-10.00, 10.00) lies off the map; the nearest reachable place is "
            "(5.00, 10.00), 15.0 m away");
  EXPECT_EQ(sentence({50, 10}, {15.2, 20.9}),
            "the goal (15.20, 20.90) lies in an obstacle; the nearest reachable place is "
            "(15.25, 19.75), 1.2 m away");
  EXPECT_NE(sentence({50, 10}, {35, 29}).find("where the map knows nothing; the nearest"),
            std::string::npos);
  EXPECT_EQ(sentence({50, 10}, {std::nan(""), 3}),
            "the goal is not a place: its coordinates must be finite");
}

TEST(AStar, AVastSnapDistanceCostsNoMoreThanTheMap) {
  OccupancyGrid grid = open_ground();
  fill(grid, 0, 15, 60, 50, OccupancyGrid::kOccupied);
  const auto sentence = error_of([&] {
    planner(bent_road(), {20, 40}, {50, 10})
        .input("grid", grid)
        .set("snap_distance", 1e9)
        .apply<Path>();
  });
  EXPECT_NE(sentence.find("lies in an obstacle; the nearest reachable place is (19.75, 14.75)"),
            std::string::npos)
      << sentence;
}

TEST(AStar, NamesARoadWhenNoFreeGroundNearbyLeadsToOne) {
  OccupancyGrid grid = open_ground();
  fill(grid, 10, 20, 20, 30, OccupancyGrid::kOccupied);
  fill(grid, 13, 23, 17, 27, OccupancyGrid::kFree);  // walled in
  const auto sentence = error_of([&] {
    planner(bent_road(), {15, 25}, {50, 10}).input("grid", grid).apply<Path>();
  });
  EXPECT_EQ(sentence,
            "the start (15.00, 25.00) has no way through free ground to any road within the "
            "snap_distance of 50.0 m; the nearest reachable place is (15.00, 10.00), 15.0 m away");
}

TEST(AStar, TooFarFromAnyRoadIsRefused) {
  const auto sentence = error_of([] {
    planner(bent_road(), {20, 70}, {50, 10}).set("snap_distance", 20.0).apply<Path>();
  });
  EXPECT_NE(sentence.find("lies 46.1 m from the nearest road"), std::string::npos) << sentence;
  EXPECT_NE(sentence.find("nearest reachable place is (55.00, 40.00)"), std::string::npos);
}

TEST(AStar, AGoalOnAnotherIslandIsRefusedWithTheNearestReachablePlace) {
  RoadGraph graph = bent_road();
  graph.nodes.push_back({4, 5, 40, 0});
  graph.nodes.push_back({5, 30, 40, 0});
  add_road(graph, 3, 4);
  EXPECT_EQ(error_of([&] {
              planner(graph, {20, 10}, {30, 40}).apply<Path>();
            }),
            "the goal (30.00, 40.00) cannot be reached from the start by road; the nearest "
            "reachable place is (55.00, 40.00), 25.0 m away");
}

TEST(AStar, RespectsOneWayAndClosedRoads) {
  RoadGraph graph = bent_road();
  graph.edges[1].direction = RoadDirection::kBackward;
  EXPECT_NE(error_of([&] {
              planner(graph, {20, 10}, {55, 30}).apply<Path>();
            }).find("cannot be reached"),
            std::string::npos);
  EXPECT_NEAR(planner(graph, {55, 30}, {20, 10}).apply<Path>().length, 55, 1e-9);
  graph.edges[1].closed = 1;
  EXPECT_NE(error_of([&] {
              planner(graph, {20, 10}, {55, 39}).set("snap_distance", 20.0).apply<Path>();
            }).find("from the nearest road"),
            std::string::npos);
  graph.edges[0].closed = 1;
  EXPECT_NE(error_of([&] { planner(graph, {}, {}).apply<Path>(); }).find("none of the 2 roads"),
            std::string::npos);
  EXPECT_NE(error_of([] { planner({}, {}, {}).apply<Path>(); }).find("has no roads"),
            std::string::npos);
}

TEST(AStar, StartAndGoalMayBeTheSamePlace) {
  const Path path = planner(bent_road(), {20, 10}, {20, 10}).apply<Path>();
  EXPECT_EQ(path.length, 0);
  EXPECT_FALSE(path.points.empty());
}

// Round a square of 20 m, from its lower left corner back to it.
RoadGraph ring() {
  RoadGraph graph;
  graph.nodes = {{1, 0, 0, 0}};
  add_road(graph, 0, 0, {{20, 0}, {20, 20}, {0, 20}});
  return graph;
}

TEST(AStar, OnARingItDrivesToTheFarSide) {
  auto stage = planner(ring(), {}, {});
  const Path path = stage.apply<Path>();
  EXPECT_NEAR(path.length, 40, 1e-9);
  EXPECT_NEAR(path.points.back().x, 20, 1e-9);
  EXPECT_NEAR(path.points.back().y, 20, 1e-9);
  const auto& said = stage.context().sentences;
  ASSERT_EQ(said.size(), 3U);
  EXPECT_EQ(said[1],
            "no goal is given: the place at (20.00, 20.00) is taken, the far side of the ring on "
            "which the start lies");
  EXPECT_EQ(said[2], "planned 40.0 m along 1 road");
}

TEST(AStar, AlsoOnARingOfOneWayAndToAGivenEndOnTheNode) {
  for (const auto direction :
       {RoadDirection::kBoth, RoadDirection::kForward, RoadDirection::kBackward}) {
    RoadGraph graph = ring();
    graph.edges[0].direction = direction;
    EXPECT_NEAR(planner(graph, {}, {}).apply<Path>().length, 40, 1e-9);
    EXPECT_NEAR(planner(graph, {0, 0}, {}).apply<Path>().length, 40, 1e-9);
    EXPECT_NEAR(planner(graph, {}, {0, 0}).apply<Path>().length, 40, 1e-9);
  }
}

TEST(AStar, OfTwoRingsAtANodeItTakesTheLonger) {
  RoadGraph graph = ring();
  add_road(graph, 0, 0, {{-30, 0}, {-30, 30}, {0, 30}});
  const Path path = planner(graph, {}, {}).apply<Path>();
  EXPECT_NEAR(path.length, 60, 1e-9);
  EXPECT_EQ(path.edges, (std::vector<std::uint64_t>{1001}));
}

TEST(AStar, FindsAWayWhereAllRoadsLeadToTheFirstNode) {
  RoadGraph graph = bent_road();
  graph.edges[0].direction = graph.edges[1].direction = RoadDirection::kBackward;
  auto stage = planner(graph, {}, {});
  EXPECT_NEAR(stage.apply<Path>().length, 80, 1e-9);
  EXPECT_EQ(stage.context().sentences.back(), "planned 80.0 m along 2 roads");
}

TEST(AStar, StartAndGoalAreTwoNumbers) {
  const StageHarness stage(stope_stage_AStar());
  for (const std::size_t place : {0U, 1U}) {
    const ParameterInfo& parameter = stage.info().parameters[place];
    EXPECT_EQ(parameter.unit, "m");
    EXPECT_EQ(parameter.limits.count_least, 2);
    EXPECT_EQ(parameter.limits.count_most, 2);
  }
}

}  // namespace
}  // namespace stope::planner
