// What an operator or a live grid says of the roads now, through the stage.
#include <gtest/gtest.h>

#include <cmath>

#include "stope/testing/memory_context.hpp"
#include "tests/plugins/planner/drawn_ground.hpp"
#include "tests/plugins/planner/planner_stage.hpp"
#include "tests/plugins/planner/test_roads.hpp"

extern "C" const stope::StageEntry* stope_stage_AStar();

namespace stope::planner {
namespace {

using stope::testing::error_of;
using stope::testing::StageHarness;
using Texts = std::vector<std::string>;

// Two ways from (5, 10) to (55, 10): straight, 50 m (road 1000), and round by y = 30, 90 m (road
// 1001); a stub leads in and one out.
RoadGraph two_ways() {
  RoadGraph graph;
  graph.nodes = {{1, 2, 10, 0}, {2, 5, 10, 0}, {3, 55, 10, 0}, {4, 58, 10, 0}};
  add_road(graph, 1, 2);
  add_road(graph, 1, 2, {{5, 30}, {55, 30}});
  add_road(graph, 0, 1);
  add_road(graph, 2, 3);
  return graph;
}

StageHarness planner(RoadGraph graph = two_ways()) {
  return planner_stage(stope_stage_AStar(), std::move(graph), {2, 10}, {58, 10});
}

// 60 x 40 m.
OccupancyGrid ground() { return free_ground(120, 80); }

constexpr double kStraight = 56, kRound = 96;

TEST(Rerouting, ClosedPlacesAndRoadsAreDrivenRound) {
  for (const char* search : {"a_star", "landmarks", "hierarchy"}) {
    SCOPED_TRACE(search);
    const auto stage = [&] {
      StageHarness made = planner();
      made.set("search", std::string(search));
      return made;
    };
    EXPECT_NEAR(stage().apply<Path>().length, kStraight, 1e-9);
    EXPECT_NEAR(stage().set("closed_places", Numbers{30, 11}).apply<Path>().length, kRound, 1e-9);
    EXPECT_NEAR(stage().set("closed_roads", Texts{"1000"}).apply<Path>().length, kRound, 1e-9);
    EXPECT_NEAR(stage().set("slow_places", Numbers{30, 11, 1.5}).apply<Path>().length, kStraight,
                1e-9);
    EXPECT_NEAR(stage().set("slow_places", Numbers{30, 11, 2}).apply<Path>().length, kRound, 1e-9);
  }
}

TEST(Rerouting, AnObstacleOnTheRoadIsDrivenRoundAndSaid) {
  OccupancyGrid grid = ground();
  fill(grid, 29, 9, 31, 11, OccupancyGrid::kOccupied);
  auto stage = planner();
  EXPECT_NEAR(stage.input("grid", grid).apply<Path>().length, kRound, 1e-9);
  EXPECT_EQ(stage.context().sentences.at(0),
            "one road is obstructed now, the first at (29.00, 10.00): the way leads round");
  EXPECT_NEAR(planner().input("grid", grid).set("avoid_obstructed", false).apply<Path>().length,
              kStraight, 1e-9);
  // What is not known is no obstacle.
  OccupancyGrid unknown = ground();
  fill(unknown, 29, 9, 31, 11, OccupancyGrid::kUnknown);
  EXPECT_NEAR(planner().input("grid", unknown).apply<Path>().length, kStraight, 1e-9);
}

// As in graphs that were imported.
TEST(Rerouting, AnObstacleOnARoadOfUnknownClearanceIsDrivenRound) {
  RoadGraph graph = two_ways();
  for (RoadVertex& vertex : graph.vertices) vertex.clearance = std::nan("");
  OccupancyGrid grid = ground();
  fill(grid, 29, 12, 31, 14, OccupancyGrid::kOccupied);  // beside the road
  EXPECT_NEAR(planner(graph).input("grid", grid).apply<Path>().length, kStraight, 1e-9);
  fill(grid, 29, 9, 31, 11, OccupancyGrid::kOccupied);
  EXPECT_NEAR(planner(graph).input("grid", grid).apply<Path>().length, kRound, 1e-9);
}

TEST(Rerouting, AnObstacleBesideTheRoadCountsWhereItTakesTheClearanceAsked) {
  OccupancyGrid grid = ground();
  fill(grid, 29, 12, 31, 14, OccupancyGrid::kOccupied);  // 2.25 m from the centre line
  const auto length = [&](double min_clearance) {
    return planner().input("grid", grid).set("min_clearance", min_clearance).apply<Path>().length;
  };
  EXPECT_NEAR(length(1), kStraight, 1e-9);
  EXPECT_NEAR(length(2), kStraight, 1e-9);
  EXPECT_NEAR(length(3), kRound, 1e-9);
}

TEST(Rerouting, WhereNoWayIsLeftItSaysWhat) {
  OccupancyGrid grid = ground();
  fill(grid, 29, 0, 31, 40, OccupancyGrid::kOccupied);
  EXPECT_EQ(error_of([&] { planner().input("grid", grid).apply<Path>(); }),
            "the goal (58.00, 10.00) cannot be reached from the start by road, as 2 roads are "
            "obstructed now, the first at (29.00, 10.00); the nearest reachable place is (28.90, "
            "10.00), 29.1 m away");
  EXPECT_NE(error_of([&] {
              planner().set("closed_places", Numbers{30, 10, 30, 30}).apply<Path>();
            }).find("with the roads closed that closed_places and closed_roads name"),
            std::string::npos);
}

TEST(Rerouting, BadChangesAreRefusedWithTheNearest) {
  const auto sentence = [](const char* name, auto value) {
    return error_of([&] { planner().set(name, value).template apply<Path>(); });
  };
  EXPECT_EQ(sentence("closed_places", Numbers{30, 100}),
            "closed_places names the place (30.00, 100.00), where no road is; the nearest road is "
            "at (30.00, 30.00), 70.0 m away, farther than the snap_distance of 50.0 m");
  EXPECT_EQ(sentence("closed_places", Numbers{30}),
            "closed_places has 1 numbers; they must come as [x, y, x, y, …]");
  EXPECT_EQ(sentence("closed_roads", Texts{"1007"}),
            "closed_roads names the road 1007, which the road graph does not have; of its 4 roads "
            "the nearest number is 1003");
  EXPECT_NE(sentence("closed_roads", Texts{"main road"}).find("is not the id of a road"),
            std::string::npos);
  EXPECT_NE(sentence("slow_places", Numbers{30, 10, 0.5}).find("only be made dearer"),
            std::string::npos);
  EXPECT_NE(sentence("slow_places", Numbers{30, std::nan(""), 2}).find("not finite"),
            std::string::npos);
  EXPECT_NE(sentence("closed_roads", Texts{"1000", "1001", "1002", "1003"}).find("all roads"),
            std::string::npos);
}

TEST(Rerouting, DamagedRoadsAreRefused) {
  RoadGraph graph = two_ways();
  graph.vertices[3].x = std::nan("");
  EXPECT_NE(error_of([&] { planner(graph).apply<Path>(); }).find("are not finite"),
            std::string::npos);
  graph = two_ways();
  graph.edges[1].to = 9;
  EXPECT_NE(error_of([&] { planner(graph).apply<Path>(); }).find("the graph is damaged"),
            std::string::npos);
}

TEST(Rerouting, AWiredPoseIsTheStart) {
  StampedPose pose;
  pose.T_map_lidar.translation = {20, 12, 3};
  const Path path = planner().input("pose", pose).apply<Path>();
  EXPECT_NEAR(path.length, 2 + 38, 1e-9);
  EXPECT_EQ(path.points.front().x, 20);
}

TEST(Rerouting, KeepsNothingOfEarlierItemsButTheirPreparation) {
  auto stage = planner();
  EXPECT_NEAR(stage.apply<Path>().length, kStraight, 1e-9);
  OccupancyGrid grid = ground();
  fill(grid, 29, 9, 31, 11, OccupancyGrid::kOccupied);
  EXPECT_NEAR(stage.input("grid", grid).apply<Path>().length, kRound, 1e-9);
  EXPECT_NEAR(stage.input("grid", ground()).apply<Path>().length, kStraight, 1e-9);
  RoadGraph longer = two_ways();
  longer.edges[0].closed = 1;
  EXPECT_NEAR(stage.input("roads", longer).apply<Path>().length, kRound, 1e-9);
}

TEST(Rerouting, TheNearestPlaceForAStartIsOneThatLeadsToTheGoal) {
  RoadGraph graph = two_ways();
  graph.nodes.push_back({5, 20, 60, 0});  // an island, nearest to the start
  graph.nodes.push_back({6, 40, 60, 0});
  add_road(graph, 4, 5);
  auto stage = planner(graph);
  stage.set("start", Numbers{30, 115});
  EXPECT_NE(error_of([&] {
              stage.apply<Path>();
            }).find("the nearest reachable place is (30.00, 30.00), 85.0 m away"),
            std::string::npos);
}

TEST(Rerouting, AOneWayDeadEndIsNoWayOut) {
  RoadGraph graph = two_ways();
  graph.edges[3].direction = RoadDirection::kForward;  // into (58, 10) only
  EXPECT_NEAR(planner(graph).apply<Path>().length, kStraight, 1e-9);
  auto stage = planner(graph);
  stage.set("start", Numbers{58, 10}).set("goal", Numbers{2, 10});
  EXPECT_EQ(error_of([&] { stage.apply<Path>(); }),
            "the goal (2.00, 10.00) cannot be reached from the start by road; the nearest "
            "reachable place is (58.00, 10.00), 56.0 m away");
}

// Four roads of 25 m that meet at (30, 30), 10 m wide,
// numbered 1000 to 1003.
RoadGraph crossing() {
  RoadGraph graph;
  graph.nodes = {{1, 30, 30, 0}, {2, 30, 5, 0}, {3, 30, 55, 0}, {4, 5, 30, 0}, {5, 55, 30, 0}};
  for (std::uint32_t arm = 1; arm <= 4; ++arm) add_road(graph, 0, arm);
  return graph;
}

TEST(Rerouting, AClosedJunctionIsClosedToAllItsRoads) {
  const auto way = [](Numbers goal, Numbers closed) {
    auto stage = planner_stage(stope_stage_AStar(), crossing(), {30, 5}, goal);
    stage.set("closed_places", closed);
    return stage;
  };
  for (const Numbers& goal : {Numbers{30, 55}, Numbers{5, 30}, Numbers{55, 30}}) {
    for (const Numbers& place : {Numbers{30, 30}, Numbers{30.3, 31.4}}) {
      const auto sentence = error_of([&] { way(goal, place).apply<Path>(); });
      // It says how far one comes: to just before the junction, and no false place.
      EXPECT_NE(sentence.find("cannot be reached from the start by road with the roads closed"),
                std::string::npos)
          << sentence;
      EXPECT_NE(sentence.find("the nearest reachable place is (30.00, 29.90)"), std::string::npos)
          << sentence;
    }
  }
  // 4 m into one road only that road is closed; its own other side is beyond reach.
  EXPECT_NEAR(way({55, 30}, {30, 34}).apply<Path>().length, 50, 1e-9);
  EXPECT_NE(error_of([&] {
              way({30, 55}, {30, 34}).apply<Path>();
            }).find("the nearest reachable place is (30.00, 33.90), 21.1 m away"),
            std::string::npos);
  auto up_to = way({30, 28}, {30, 30});
  EXPECT_NEAR(up_to.apply<Path>().length, 23, 1e-9);
  EXPECT_EQ(up_to.context().sentences.at(0),
            "closed_places: at (30.00, 30.00) 4 roads are closed, as all pass within 2.5 m: 1000, "
            "1001, 1002, 1003");
}

TEST(Rerouting, NoShortcutLeadsAcrossAClosedJunction) {
  OccupancyGrid grid = ground();
  grid.cells.assign(grid.frame.size(), OccupancyGrid::kOccupied);
  fill(grid, 25, 0, 35, 40, OccupancyGrid::kFree);
  fill(grid, 0, 15, 60, 25, OccupancyGrid::kFree);
  RoadGraph graph;
  graph.nodes = {{1, 30, 20, 0}, {2, 30, 2, 0}, {3, 30, 38, 0}, {4, 2, 20, 0}, {5, 58, 20, 0}};
  for (std::uint32_t arm = 1; arm <= 4; ++arm) add_road(graph, 0, arm);
  // A long way round, so that there is one: drawn through the walls, which nobody looks at here.
  add_road(graph, 1, 3, {{2, 2}});
  const auto way = [&](bool shortcut) {
    auto stage = planner_stage(stope_stage_AStar(), graph, {30, 2}, {2, 20});
    stage.input("grid", grid).set("closed_places", Numbers{30, 20}).set("avoid_obstructed", false);
    return stage.set("shortcut", shortcut).apply<Path>();
  };
  EXPECT_NEAR(way(false).length, 46, 1e-6);
  for (const PathPoint& point : way(true).points)
    EXPECT_GT(std::hypot(point.x - 30, point.y - 20), 5) << point.x << ", " << point.y;
}

}  // namespace
}  // namespace stope::planner
