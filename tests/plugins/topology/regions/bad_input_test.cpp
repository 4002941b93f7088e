#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "tests/plugins/topology/regions/region_stages.hpp"

namespace stope::topology {
namespace {

std::string error_with(const StageEntry* entry, const OccupancyGrid& grid) {
  return error_of([&] { for_rooms(entry).input("grid", grid).apply<RoadGraph>(); });
}

TEST(RegionStages, RefuseGridsThatCannotBe) {
  for (const StageEntry* entry : region_stages()) {
    EXPECT_NE(error_with(entry, {}).find("is empty"), std::string::npos);
    EXPECT_NE(error_with(entry, grid_of({"###", "###"})).find("no free cell"), std::string::npos);
    for (const double resolution : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()}) {
      OccupancyGrid grid = two_rooms();
      grid.frame.resolution = resolution;
      EXPECT_NE(error_with(entry, grid).find("resolution"), std::string::npos) << resolution;
    }
    OccupancyGrid torn = two_rooms();
    torn.cells.pop_back();
    EXPECT_NE(error_with(entry, torn).find("holds"), std::string::npos);
  }
}

TEST(RegionStages, OneFreeCellIsOneRegionWithoutARoad) {
  for (const StageEntry* entry : region_stages()) {
    const OccupancyGrid grid = grid_of({"###", "#.#", "###"}, 0.1);
    EXPECT_NE(error_with(entry, grid).find("one single region"), std::string::npos);
    StageHarness stage = for_rooms(entry);
    stage.set("allow_empty", true).input("grid", grid);
    EXPECT_EQ(stage.apply<RegionMap>(1).regions.size(), 1U);
    EXPECT_EQ(stage.apply<RoadGraph>(0).nodes.size(), 1U);
  }
}

TEST(RegionStages, AFullyFreeGridIsCovered) {
  for (const StageEntry* entry : region_stages()) {
    StageHarness stage = for_rooms(entry);
    const OccupancyGrid grid = grid_where(12, 9, 0.1, [](double, double) { return true; });
    stage.set("allow_empty", true).input("grid", grid);
    const auto map = stage.apply<RegionMap>(1);
    const std::vector<std::int32_t> labels = map.labels.cells.to_vector();
    EXPECT_EQ(std::count(labels.begin(), labels.end(), 0), 0);
  }
}

TEST(RegionGrowing, RoomsJustAsWideAsTheLargestRegionAreCoveredWhereverTheyLie) {
  // Their middle is in the open, but for a few cells: none of them need lie on a round number.
  for (int shift = 0; shift < 8; ++shift) {
    const OccupancyGrid grid = grid_where(7, 3.8, 0.1, [&](double x, double y) {
      const double at = x - 0.1 * shift;
      const bool wall = at > 2.9 && at < 3.1 && !(y > 1.2 && y < 1.8);
      return at > 0 && at < 6 && y > 0.1 * shift && y < 0.1 * shift + 3 && !wall;
    });
    StageHarness stage = for_rooms(stope_stage_RegionGrowing());
    stage.set("growth_radius", 0.5).set("max_radius", 1.5).set("merge_area", 5.0);
    stage.set("second_radius", 1.0).set("min_obstacle_area", 0.1).input("grid", grid);
    const auto map = stage.apply<RegionMap>(1);
    EXPECT_GE(map.regions.size(), 2U) << shift;
    const std::vector<std::int32_t> labels = map.labels.cells.to_vector();
    EXPECT_EQ(
        std::count_if(labels.begin(), labels.end(), [](std::int32_t label) { return label > 0; }),
        std::count(grid.cells.begin(), grid.cells.end(), OccupancyGrid::kFree))
        << shift;
  }
}

TEST(RegionStages, SpecksOfFreeSpaceAreLeftOutAndItIsSaid) {
  for (const StageEntry* entry : region_stages()) {
    OccupancyGrid grid = two_rooms();
    // In the walls: a crumb of four cells, and one cell alone.
    for (const Cell cell : {Cell{43, 3}, {44, 3}, {43, 4}, {44, 4}, {43, 40}})
      grid.cells[grid.frame.place(cell)] = OccupancyGrid::kFree;
    StageHarness stage = for_rooms(entry);
    const auto map = stage.input("grid", grid).apply<RegionMap>(1);
    EXPECT_EQ(map.regions.size(), 2U);
    EXPECT_EQ(map.labels.cells[grid.frame.place({43, 40})], 0);
    const auto& said = stage.context().sentences;
    EXPECT_TRUE(std::any_of(said.begin(), said.end(), [](const std::string& sentence) {
      return sentence.find("2 parts of free space, 5 cells together, are left out") !=
             std::string::npos;
    })) << said[0];
    StageHarness with_specks = for_rooms(entry);
    with_specks.set("min_region_area", 0.0).input("grid", grid);
    EXPECT_EQ(with_specks.apply<RegionMap>(1).regions.size(), 4U);
  }
}

TEST(RegionStages, PiecesThatDoNotTouchHaveGraphsOfTheirOwnAndItIsSaid) {
  for (const StageEntry* entry : region_stages()) {
    const OccupancyGrid rooms = two_rooms();
    OccupancyGrid grid = rooms;  // twice, one above the other
    grid.frame.height *= 2;
    grid.cells.insert(grid.cells.end(), rooms.cells.begin(), rooms.cells.end());
    StageHarness stage = for_rooms(entry);
    stage.input("grid", grid);
    EXPECT_EQ(stage.apply<RegionMap>(1).regions.size(), 4U);
    EXPECT_EQ(stage.apply<RoadGraph>(0).edges.size(), 2U);
    const auto& said = stage.context().sentences;
    EXPECT_TRUE(std::any_of(said.begin(), said.end(), [](const std::string& sentence) {
      return sentence.find("2 parts that do not touch") != std::string::npos;
    }));
  }
}

TEST(RegionStages, WhenAllDoorsAreTooNarrowTheySayWhatToDo) {
  for (const StageEntry* entry : region_stages()) {
    const std::string said = error_of([&] {
      for_rooms(entry).set("min_clearance", 0.7).input("grid", two_rooms()).apply<RoadGraph>();
    });
    EXPECT_NE(said.find("narrower than twice min_clearance (0.7 m)"), std::string::npos) << said;
  }
}

bool says(StageHarness& stage, const std::string& part) {
  const auto& said = stage.context().sentences;
  return std::any_of(said.begin(), said.end(), [&](const std::string& sentence) {
    return sentence.find(part) != std::string::npos;
  });
}

TEST(RegionStages, OneRegionIsSpokenOfAsOne) {
  for (const StageEntry* entry : region_stages()) {
    StageHarness stage = for_rooms(entry);
    stage.set("allow_empty", true).input("grid", grid_of({"###", "#.#", "###"}, 0.1));
    stage.apply<RegionMap>(1);
    EXPECT_TRUE(says(stage, "1 region covers 1.0000 of the free cells"));
  }
}

TEST(RegionGrowing, NetworksThatAreApartAreNotSaidToHaveNoWayBetweenThem) {
  // There may be one, behind a place too narrow in a region of its own.
  std::size_t apart = 0;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    OccupancyGrid grid = random_grid(90, 70, 0.86, 7, seed);
    grid.frame.resolution = 0.1;
    StageHarness stage = for_rooms(stope_stage_RegionGrowing());
    stage.set("allow_empty", true).set("min_clearance", 0.25).set("min_obstacle_area", 0.0);
    stage.input("grid", grid).apply<RoadGraph>(0);
    EXPECT_FALSE(says(stage, "no way wider"));
    if (!says(stage, "networks of their own")) continue;
    ++apart;
    EXPECT_TRUE(says(stage, "hang together only where it is narrower"));
  }
  EXPECT_GT(apart, 2U);
}

TEST(RegionGrowing, GapsBetweenRegionsAreNotBlamedOnFreeSpace) {
  // What grows from one pose ends a metre on; free space is one piece, or two.
  for (const bool wall : {false, true}) {
    OccupancyGrid grid =
        grid_where(12, 6, 0.1, [&](double x, double) { return !wall || x < 5.5 || x > 6.5; });
    Trajectory trajectory;
    for (const double x : {1.5, 4.0, 7.9, 10.5}) {
      trajectory.poses.push_back({static_cast<Stamp>(trajectory.poses.size()), {}});
      trajectory.poses.back().T_map_lidar.translation = {x, 3, 0};
    }
    StageHarness stage = for_rooms(stope_stage_RegionGrowing());
    stage.set("mode", std::string("paper")).set("coverage", 0.2).set("radius_weight", 0.0);
    stage.set("growth_radius", 0.9).set("max_radius", 0.9).set("second_radius", 0.0);
    stage.set("allow_empty", true).input("grid", grid).input("trajectory", trajectory);
    const auto map = stage.apply<RegionMap>(1);
    ASSERT_TRUE(map.adjacency.empty());
    ASSERT_GT(map.regions.size(), 2U);
    EXPECT_FALSE(says(stage, "because free space does"));
    EXPECT_TRUE(
        says(stage, wall ? "although free space is 2 pieces only" : "although free space is one"))
        << stage.context().sentences.back();
  }
}

TEST(RegionGrowing, WithoutAnyRegionItIsNotSaidThatNoneTouch) {
  const std::string said = error_of([&] {
    for_rooms(stope_stage_RegionGrowing())
        .set("mode", std::string("paper"))
        .set("coverage", 0.0)
        .input("grid", two_rooms())
        .apply<RoadGraph>();
  });
  EXPECT_NE(said.find("there is no region, because none grew"), std::string::npos) << said;
}

TEST(RegionGrowing, ATrajectoryOffTheMapOrInObstaclesIsSaidAndDoesNotHurt) {
  Trajectory trajectory;
  for (const double x : {-5.0, 0.05, 2.0}) {
    trajectory.poses.push_back({static_cast<Stamp>(trajectory.poses.size()), {}});
    trajectory.poses.back().T_map_lidar.translation = {x, 2, 0};
  }
  StageHarness stage = for_rooms(stope_stage_RegionGrowing());
  stage.input("grid", two_rooms()).input("trajectory", trajectory);
  EXPECT_EQ(stage.apply<RegionMap>(1).regions.size(), 2U);
  EXPECT_NE(stage.context().sentences[0].find(
                "1 of the trajectory's 3 poses lie outside of the map and 1 in cells"),
            std::string::npos)
      << stage.context().sentences[0];
  trajectory.poses.pop_back();
  stage.input("trajectory", trajectory);
  EXPECT_EQ(stage.apply<RegionMap>(1).regions.size(), 2U);
  EXPECT_NE(stage.context().sentences[3].find("None is left"), std::string::npos);
  stage.input("trajectory", Trajectory{});
  EXPECT_EQ(stage.apply<RegionMap>(1).regions.size(), 2U);
}

TEST(RegionGrowing, ACellLargerThanTheGrowthRadiusIsRefused) {
  OccupancyGrid grid = two_rooms();
  grid.frame.resolution = 1000;
  EXPECT_NE(error_with(stope_stage_RegionGrowing(), grid).find("less than one cell"),
            std::string::npos);
}

TEST(RegionGrowing, AnAbsurdlyFineResolutionIsRefusedAndAFineOneIsNot) {
  OccupancyGrid grid = two_rooms();
  grid.frame.resolution = 1e-9;
  EXPECT_NE(error_with(stope_stage_RegionGrowing(), grid).find("resolution"), std::string::npos);
  grid.frame.resolution = 0.001;
  StageHarness stage = for_rooms(stope_stage_RegionGrowing());
  stage.set("allow_empty", true).set("min_clearance", 0.0).set("min_obstacle_area", 0.0);
  EXPECT_GE(stage.input("grid", grid).apply<RegionMap>(1).regions.size(), 1U);
}

TEST(RegionStages, GiveUpWhenTheRunIsCancelled) {
  for (const StageEntry* entry : region_stages()) {
    StageHarness stage = for_rooms(entry);
    stage.input("grid", two_rooms()).context().cancel = true;
    EXPECT_THROW(stage.apply<RoadGraph>(), Cancelled);
  }
}

}  // namespace
}  // namespace stope::topology
