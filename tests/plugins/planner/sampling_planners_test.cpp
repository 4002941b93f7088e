// planner/ompl_prm and planner/ompl_bit_star: ways through free ground, the same bytes each time.
#include <gtest/gtest.h>

#include <cmath>
#include <thread>

#include "stope/digest.hpp"
#include "tests/plugins/planner/test_roads.hpp"
#include "tests/plugins/stage_harness.hpp"

extern "C" const stope::StageEntry* stope_stage_AStar();
extern "C" const stope::StageEntry* stope_stage_OmplPrm();
extern "C" const stope::StageEntry* stope_stage_OmplBitStar();

namespace stope::planner {
namespace {

using stope::testing::error_of;
using stope::testing::StageHarness;
using Numbers = std::vector<double>;

// Open ground of 60 x 50 m with a road that makes a detour of 90 m between places 50 m apart, and a
// block of 4 m in the straight line between them.
RoadGraph detour() {
  RoadGraph graph;
  graph.nodes = {{1, 5, 10, 0}, {2, 55, 10, 0}};
  add_road(graph, 0, 1, {{5, 30}, {55, 30}}, 20);
  return graph;
}

OccupancyGrid ground() {
  OccupancyGrid grid;
  grid.frame = {120, 100, 0.5, {}};
  grid.cells.assign(grid.frame.size(), OccupancyGrid::kFree);
  for (std::int32_t row = 16; row < 24; ++row)
    for (std::int32_t column = 56; column < 64; ++column)
      grid.cells[grid.frame.place({column, row})] = OccupancyGrid::kOccupied;
  return grid;
}

const std::vector<const StageEntry* (*)()> kStages{stope_stage_OmplPrm, stope_stage_OmplBitStar};

StageHarness planner(const StageEntry* entry, RoadGraph graph = detour()) {
  StageHarness stage(entry);
  stage.input("roads", std::move(graph));
  stage.set("start", Numbers{5, 10});
  stage.set("goal", Numbers{55, 10});
  return stage;
}

TEST(SamplingPlanners, FindShorterWaysThroughFreeGround) {
  for (const auto entry : kStages) {
    auto stage = planner(entry());
    const OccupancyGrid grid = ground();
    const Path path = stage.input("grid", grid).apply<Path>();
    // Past the block's corner at (28, 12) or (28, 8), at least.
    EXPECT_GE(path.length, 2 * std::hypot(23, 2) + 4 - 1e-6);
    EXPECT_LT(path.length, 60);
    for (const PathPoint& point : path.points) {
      const auto cell = grid.frame.cell_at(point.x, point.y);
      ASSERT_TRUE(cell);
      EXPECT_EQ(grid.cells[grid.frame.place(*cell)], OccupancyGrid::kFree);
    }
  }
}

TEST(SamplingPlanners, WithoutAGridTheyPlanByRoad) {
  for (const auto entry : kStages) {
    const Path path = planner(entry()).apply<Path>();
    EXPECT_NEAR(path.length, 90, 1e-9);
    EXPECT_EQ(path.edges, std::vector<std::uint64_t>{1000});
  }
}

TEST(SamplingPlanners, KeepOutOfClosedRoads) {
  for (const auto entry : kStages) {
    RoadGraph graph = detour();
    add_road(graph, 0, 1, {}, 8);  // the straight way, closed
    graph.edges[1].closed = 1;
    OccupancyGrid grid = ground();
    grid.cells.assign(grid.cells.size(), OccupancyGrid::kFree);
    const Path path = planner(entry(), graph).input("grid", grid).apply<Path>();
    for (const PathPoint& point : path.points) {
      if (point.x > 20 && point.x < 40) {
        EXPECT_GT(std::abs(point.y - 10), 7.5);
      }
    }
  }
}

// Roads that the roadmap adds in the ground round the lower road pass nearer to the place than the
// upper one, which is meant.
TEST(SamplingPlanners, PrmClosesARoadThatWasThereAndNoneItAdded) {
  RoadGraph graph;
  graph.nodes = {{1, 5, 30, 0}, {2, 55, 30, 0}, {3, 5, 45, 0}, {4, 55, 45, 0}};
  add_road(graph, 0, 1, {}, 20);
  add_road(graph, 2, 3, {}, 1);
  add_road(graph, 0, 2);
  add_road(graph, 1, 3);
  auto stage = planner(stope_stage_OmplPrm(), graph);
  stage.set("start", Numbers{5, 45}).set("goal", Numbers{55, 45}).input("grid", ground());
  EXPECT_NEAR(stage.apply<Path>().length, 50, 1e-9);
  EXPECT_GT(stage.set("closed_places", Numbers{30, 38.5}).apply<Path>().length, 55);
}

TEST(SamplingPlanners, WithoutStartAndGoalTheyTakeThoseOfAStar) {
  const OccupancyGrid grid = ground();
  RoadGraph graph = detour();
  graph.nodes.push_back({3, 30, 45, 0});
  add_road(graph, 1, 2, {}, 5);
  const auto ends = [&](const StageEntry* entry, bool with_start) {
    StageHarness stage(entry);
    stage.input("roads", graph).input("grid", grid);
    if (with_start) stage.set("start", Numbers{30, 29});
    const Path path = stage.apply<Path>();
    return Numbers{path.points.front().x, path.points.front().y, path.points.back().x,
                   path.points.back().y};
  };
  for (const bool with_start : {false, true}) {
    const Numbers by_road = ends(stope_stage_AStar(), with_start);
    for (const auto entry : kStages) EXPECT_EQ(ends(entry(), with_start), by_road);
  }
}

TEST(SamplingPlanners, RefuseAsTheOthersDo) {
  for (const auto entry : kStages) {
    EXPECT_NE(error_of([&] { planner(entry(), {}).apply<Path>(); }).find("has no roads"),
              std::string::npos);
    auto stage = planner(entry());
    stage.set("goal", Numbers{200, 10}).input("grid", ground());
    EXPECT_NE(error_of([&] { stage.apply<Path>(); }).find("the goal (200.00, 10.00) lies off"),
              std::string::npos);
  }
}

// OMPL numbers what it makes and seeds its generators from counters that a whole process shares.
TEST(SamplingPlanners, PrmGivesTheSameBytesTwentyTimesOnOneAndEightThreads) {
  const auto digest = [] {
    auto stage = planner(stope_stage_OmplPrm());
    stage.input("grid", ground()).set("samples", std::int64_t{100});
    return digest_of(stage.apply<Path>());
  };
  const Digest first = digest();
  for (int i = 0; i < 20; ++i) EXPECT_EQ(digest(), first);
  std::vector<Digest> digests(8);
  std::vector<std::thread> threads;
  for (Digest& each : digests) threads.emplace_back([&each, &digest] { each = digest(); });
  for (std::thread& thread : threads) thread.join();
  for (const Digest& each : digests) EXPECT_EQ(each, first);
}

TEST(SamplingPlanners, BitStarSaysThatItMayDiffer) {
  EXPECT_FALSE(StageHarness(stope_stage_OmplBitStar()).info().deterministic);
  EXPECT_TRUE(StageHarness(stope_stage_OmplPrm()).info().deterministic);
}

}  // namespace
}  // namespace stope::planner
