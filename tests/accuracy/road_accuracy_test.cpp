#include "road_accuracy.hpp"

#include <gtest/gtest.h>

#include "synthetic_roads.hpp"

namespace stope::testing {
namespace {

// One straight road of 100 m along y = `offset`, 10 m wide.
RoadGraph straight(double offset) {
  RoadGraph graph;
  graph.nodes = {{0, 0, offset, 0}, {0, 100, offset, 0}};
  graph.vertices = {{0, offset, 0, 5}, {100, offset, 0, 5}};
  RoadEdge edge;
  edge.from = 0, edge.to = 1, edge.first_vertex = 0, edge.vertex_count = 2, edge.width = 10;
  graph.edges = {edge};
  canonicalize(graph);
  return graph;
}

TEST(RoadAccuracy, AGraphIsRightAgainstItself) {
  const RoadAccuracy accuracy = measure_roads(straight(0), straight(0));
  EXPECT_DOUBLE_EQ(accuracy.correctness(), 1);
  EXPECT_DOUBLE_EQ(accuracy.completeness(), 1);
  EXPECT_EQ(accuracy.dead_ends_found, 2U);
  EXPECT_EQ(accuracy.spurs, 0U);
}

TEST(RoadAccuracy, ALineTooFarAsideIsWrongThoughOnTheRoad) {
  const RoadAccuracy accuracy = measure_roads(straight(1.5), straight(0));
  EXPECT_GT(accuracy.length_in_roads, 60);
  EXPECT_DOUBLE_EQ(accuracy.correctness(), 0);
  EXPECT_DOUBLE_EQ(accuracy.completeness(), 0);
}

class OnSyntheticPits : public ::testing::TestWithParam<int> {};

TEST_P(OnSyntheticPits, TheTrueCentreLinesAndDeadEndsAreFound) {
  const SyntheticRoads pit = synthetic_roads(500, static_cast<std::uint64_t>(GetParam()));
  for (const auto& [name, extractor] : kWithDeadEnds) {
    const RoadAccuracy accuracy = measure_roads(extract_roads(pit.grid, extractor), pit.roads);
    EXPECT_GE(accuracy.correctness(), 0.98) << name;
    EXPECT_GE(accuracy.completeness(), 0.98) << name;
    EXPECT_GE(accuracy.dead_end_recall(), 0.98) << name;
    EXPECT_EQ(accuracy.spurs, 0U) << name;
    EXPECT_EQ(accuracy.cycles, accuracy.true_cycles) << name;
  }
}

TEST_P(OnSyntheticPits, FreshlyDugFacesMakeNoRoadsAndHideNone) {
  for (const double rough : {0.0, 1.5, 3.0}) {
    const SyntheticRoads pit = synthetic_roads(500, static_cast<std::uint64_t>(GetParam()), rough);
    for (const auto& [name, extractor] : kWithDeadEnds) {
      const RoadAccuracy accuracy = measure_roads(extract_roads(pit.grid, extractor), pit.roads);
      EXPECT_EQ(accuracy.dead_ends_found, accuracy.dead_ends) << name << ", rough " << rough;
      EXPECT_EQ(accuracy.spurs, 0U) << name << ", rough " << rough;
      EXPECT_EQ(accuracy.cycles, accuracy.true_cycles) << name << ", rough " << rough;
    }
  }
}

TEST_P(OnSyntheticPits, WatershedFollowsTheTrueCentreLinesOfItsLoops) {
  const SyntheticRoads pit = synthetic_roads(500, static_cast<std::uint64_t>(GetParam()));
  const RoadAccuracy accuracy =
      measure_roads(extract_roads(pit.grid, Extractor::kWatershed), pit.roads);
  EXPECT_GE(accuracy.correctness(), 0.95);
  EXPECT_EQ(accuracy.cycles, accuracy.true_cycles);
}

INSTANTIATE_TEST_SUITE_P(Seeds, OnSyntheticPits, ::testing::Values(1, 2, 3));

}  // namespace
}  // namespace stope::testing
