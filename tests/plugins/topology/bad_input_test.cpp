// Every member, through its stage: what a map can be that is no map of roads.
#include <gtest/gtest.h>

#include <cmath>

#include "stope/plugin.hpp"
#include "stope/stope.hpp"
#include "tests/plugins/stage_harness.hpp"
#include "tests/plugins/topology/graph_checks.hpp"
#include "tests/plugins/topology/test_grids.hpp"

extern "C" const stope::StageEntry* stope_stage_Watershed();
extern "C" const stope::StageEntry* stope_stage_Voronoi();
extern "C" const stope::StageEntry* stope_stage_Skeleton();

namespace stope::topology {
namespace {

using stope::testing::error_of;
using stope::testing::StageHarness;

struct Member {
  std::string name;
  const StageEntry* (*entry)();
  std::string parameter, value;
  bool has_dead_ends = true;
};

class BadInput : public ::testing::TestWithParam<Member> {
 protected:
  BadInput() : stage(GetParam().entry()) {
    if (!GetParam().parameter.empty()) stage.set(GetParam().parameter, GetParam().value);
  }
  std::string refusal(const OccupancyGrid& grid) {
    return error_of([&] { stage.input("grid", grid).apply<RoadGraph>(); });
  }
  bool said(const std::string& words) {
    for (const std::string& sentence : stage.context().sentences)
      if (sentence.find(words) != std::string::npos) return true;
    return false;
  }
  StageHarness stage;
};

void expect_words(const std::string& sentence, const std::vector<std::string>& words) {
  for (const std::string& word : words)
    EXPECT_NE(sentence.find(word), std::string::npos) << "\"" << sentence << "\" lacks " << word;
}

TEST_P(BadInput, AGridWithoutAFreeCell) {
  expect_words(refusal(grid_of({"###", "###"})), {"no free cell", "negate"});
  expect_words(refusal(grid_of({"???", "###"})), {"no free cell", "unknown"});
}

TEST_P(BadInput, AGridThatIsNoGrid) {
  expect_words(refusal(OccupancyGrid{}), {"is empty", "0 x 0"});
  OccupancyGrid grid = grid_of({"..", ".."});
  grid.frame.width = -2;
  expect_words(refusal(grid), {"is empty", "-2 x 2"});
  grid = grid_of({"..", ".."});
  grid.cells.pop_back();
  expect_words(refusal(grid), {"2 x 2", "holds 3"});
  grid.cells.resize(7);
  expect_words(refusal(grid), {"2 x 2", "holds 7"});
}

TEST_P(BadInput, AResolutionThatIsNone) {
  for (const double resolution : {0.0, -0.0, -1.0, std::nan(""), HUGE_VAL, -HUGE_VAL})
    expect_words(refusal(grid_of({".."}, resolution)), {"resolution", "positive number"});
}

TEST_P(BadInput, AnAbsurdResolution) {
  for (const double resolution : {1e-300, 1e-9, 9e-4, 1.1e3, 1e9, 1e300})
    expect_words(refusal(grid_of({".."}, resolution)), {"resolution", "check the unit"});
}

TEST_P(BadInput, AnOriginThatIsNoPlace) {
  for (const Pose2 origin :
       {Pose2{std::nan(""), 0, 0}, Pose2{0, HUGE_VAL, 0}, Pose2{0, 0, std::nan("")}}) {
    OccupancyGrid grid = grid_of({"..", ".."});
    grid.frame.origin = origin;
    expect_words(refusal(grid), {"origin", "finite"});
  }
}

TEST_P(BadInput, AMapThatIsFreeAllOverHasNoRoadAndSaysWhatToDo) {
  const OccupancyGrid yard = grid_of(std::vector<std::string>(31, std::string(31, '.')));
  expect_words(refusal(yard), {"no road that can be extracted", "allow_empty"});
  if (GetParam().has_dead_ends) expect_words(refusal(yard), {"it has 1 open place"});
  stage.set("allow_empty", true);
  EXPECT_EQ(refusal(yard), "");
  EXPECT_TRUE(said("no road that can be extracted"));
}

TEST_P(BadInput, OneFreeCell) {
  for (const auto& rows : {std::vector<std::string>{"."}, {"###", "#.#", "###"}}) {
    expect_words(refusal(grid_of(rows)), {"no road that can be extracted"});
    stage.set("allow_empty", true).set("min_clearance", 0.0);
    const RoadGraph roads = stage.input("grid", grid_of(rows)).apply<RoadGraph>();
    EXPECT_EQ(roads.nodes.size(), GetParam().has_dead_ends ? 1U : 0U);
    EXPECT_TRUE(roads.edges.empty());
    stage.set("allow_empty", false).set("min_clearance", 2.0);
  }
}

/// Two rings and a road between, touching the map's border all round, `apart` or not.
OccupancyGrid two_rings(bool apart) {
  return grid_where(120, 50, 0.5, [=](double x, double y) {
    const bool block = std::abs(y - 25) < 12 && (std::abs(x - 25) < 12 || std::abs(x - 95) < 12);
    return !block && !(apart && std::abs(x - 60) < 3);
  });
}

TEST_P(BadInput, FreeSpaceInPiecesGivesANetworkForEachAndSaysSo) {
  const RoadGraph apart = stage.input("grid", two_rings(true)).apply<RoadGraph>();
  EXPECT_EQ(betti_of(apart), (Betti{2, 2}));
  EXPECT_TRUE(said("2 networks of their own"));
  stage.context().sentences.clear();
  const RoadGraph whole = stage.input("grid", two_rings(false)).apply<RoadGraph>();
  EXPECT_EQ(betti_of(whole), (Betti{1, 2}));
  EXPECT_FALSE(said("networks of their own"));
}

TEST_P(BadInput, MapsThatTouchTheBorderKeepTheirDistanceFromIt) {
  const RoadGraph roads = stage.input("grid", two_rings(false)).apply<RoadGraph>();
  for (const RoadVertex& vertex : roads.vertices) {
    const double border = std::min({vertex.x, vertex.y, 120 - vertex.x, 50 - vertex.y});
    EXPECT_GE(vertex.clearance, 2.0);
    EXPECT_LE(vertex.clearance, border + 0.5) << "the world ends at " << vertex.x;
  }
}

TEST_P(BadInput, AnElevationThatIsNoGridIsNamed) {
  stage.input("grid", two_rings(false)).input("elevation", ElevationGrid{});
  expect_words(error_of([&] { stage.apply<RoadGraph>(); }), {"elevation grid is empty"});
}

TEST_P(BadInput, WithElevationEveryPlaceHasItsHeightAndEveryRoadItsGrade) {
  ElevationGrid ground{{130, 60, 1.0, {-5, -5, 0}}, {}, {}};
  for (std::int32_t row = 0; row < 60; ++row)
    for (std::int32_t column = 0; column < 130; ++column)
      ground.cells.push_back(static_cast<float>(0.08 * ground.frame.centre({column, row}).x()));
  const RoadGraph roads =
      stage.input("grid", two_rings(false)).input("elevation", ground).apply<RoadGraph>();
  for (const RoadVertex& vertex : roads.vertices) EXPECT_NEAR(vertex.z, 0.08 * vertex.x, 1e-4);
  for (const RoadNode& node : roads.nodes) EXPECT_NEAR(node.z, 0.08 * node.x, 1e-4);
  double steepest = 0;
  for (const RoadEdge& edge : roads.edges) steepest = std::max(steepest, edge.grade);
  EXPECT_NEAR(steepest, 0.08, 0.001);
}

INSTANTIATE_TEST_SUITE_P(
    Members, BadInput,
    ::testing::Values(Member{"watershed", stope_stage_Watershed, "", "", false},
                      Member{"watershed_of_parts", stope_stage_Watershed, "sites", "outline_parts"},
                      Member{"voronoi", stope_stage_Voronoi, "", ""},
                      Member{"skeleton", stope_stage_Skeleton, "", ""},
                      Member{"skeleton_by_lambda", stope_stage_Skeleton, "pruning", "lambda"}),
    [](const auto& info) { return info.param.name; });

}  // namespace
}  // namespace stope::topology
