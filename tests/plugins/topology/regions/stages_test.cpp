#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "stope/plugin.hpp"
#include "stope/stope.hpp"
#include "tests/plugins/stage_harness.hpp"
#include "tests/plugins/topology/regions/region_stages.hpp"

namespace stope::topology {
namespace {

TEST(RegionStages, StandInForTheOtherMembers) {
  StageInfo voronoi;
  EXPECT_TRUE(stope_stage_Voronoi()->describe(voronoi));
  for (const StageEntry* entry : region_stages()) {
    StageInfo info;
    EXPECT_TRUE(entry->describe(info));
    ASSERT_EQ(info.inputs.size(), 2U);
    EXPECT_EQ(info.inputs[0].name, "grid");
    EXPECT_TRUE(info.inputs[0].required);
    EXPECT_EQ(info.inputs[1].name, "trajectory");
    EXPECT_FALSE(info.inputs[1].required);
    ASSERT_EQ(info.outputs.size(), 2U);
    EXPECT_EQ(info.outputs[0].name, "roads");
    EXPECT_EQ(info.outputs[0].type, voronoi.outputs[0].type);
    EXPECT_EQ(info.outputs[1].name, "regions");
    EXPECT_EQ(info.outputs[1].type, "stope/RegionMap@1");
    for (const char* common : {"min_clearance", "min_obstacle_area", "simplify",
                               "occupied_threshold", "unknown_is_obstacle", "allow_empty"})
      EXPECT_TRUE(std::any_of(info.parameters.begin(), info.parameters.end(),
                              [&](const ParameterInfo& p) { return p.name == common; }))
          << common;
  }
}

TEST(RegionStages, TwoRoomsAreTwoRegionsAndOneRoad) {
  for (const StageEntry* entry : region_stages()) {
    StageHarness stage = for_rooms(entry);
    stage.input("grid", two_rooms());
    const auto map = stage.apply<RegionMap>(1);
    const auto roads = stage.apply<RoadGraph>(0);
    ASSERT_EQ(map.regions.size(), 2U);
    EXPECT_EQ(map.adjacency, (std::vector<std::uint32_t>{0, 1}));
    ASSERT_EQ(roads.nodes.size(), 2U);
    ASSERT_EQ(roads.edges.size(), 1U);
    // The door is 1 m wide: half of it, less what cells are.
    EXPECT_NEAR(roads.edges[0].min_clearance, 0.5, 0.11);
    EXPECT_NEAR(roads.edges[0].length, 4.2, 0.6);
    for (const Region& region : map.regions) {
      EXPECT_NEAR(region.area, 16, 1.0);
      EXPECT_TRUE(std::any_of(roads.nodes.begin(), roads.nodes.end(), [&](const RoadNode& node) {
        return node.id == region.id && node.x == region.x && node.y == region.y;
      }));
    }
  }
}

TEST(RegionStages, ASpanningTreeLosesTheLoopAndASpannerNeedNot) {
  for (const StageEntry* entry : region_stages()) {
    const auto roads_with = [&](const char* network, double stretch) {
      return for_rooms(entry)
          .set("network", std::string(network))
          .set("stretch", stretch)
          .input("grid", four_rooms_in_a_ring())
          .apply<RoadGraph>(0);
    };
    const RoadGraph all = roads_with("none", 1.5);
    EXPECT_EQ(all.edges.size(), all.nodes.size());
    EXPECT_EQ(roads_with("mst", 1.5).edges.size(), all.nodes.size() - 1);
    EXPECT_EQ(roads_with("spanner", 1.5).edges.size(), all.nodes.size());
    EXPECT_EQ(roads_with("spanner", 9.0).edges.size(), all.nodes.size() - 1);
  }
}

TEST(RegionGrowing, GrowsFromTheTrajectoryFirst) {
  const OccupancyGrid grid = two_rooms();
  Trajectory trajectory;
  trajectory.poses.push_back({0, {}});
  trajectory.poses[0].T_map_lidar.translation = {1.35, 1.35, 0};
  StageHarness stage = for_rooms(stope_stage_RegionGrowing());
  const auto map = stage.set("growth_radius", 0.5)
                       .set("max_radius", 1.0)
                       .set("merge_radius", 0.0)
                       .set("second_radius", 0.0)
                       .input("grid", grid)
                       .input("trajectory", trajectory)
                       .apply<RegionMap>(1);
  const auto centre = std::find_if(map.regions.begin(), map.regions.end(), [](const Region& r) {
    return std::hypot(r.x - 1.35, r.y - 1.35) < 0.1;
  });
  ASSERT_NE(centre, map.regions.end());
  EXPECT_NEAR(centre->area, 3.14159 * 1.05 * 1.05, 0.1);  // rings of cells, half a cell more
}

TEST(RegionGrowing, PaperModeIsRandomBySeedOnly) {
  const auto labels = [&](std::uint64_t seed) {
    StageHarness stage = for_rooms(stope_stage_RegionGrowing());
    stage.set("mode", std::string("paper")).set("allow_empty", true).context().reseed(seed);
    return stage.input("grid", four_rooms_in_a_ring()).apply<RegionMap>(1).labels.cells.to_vector();
  };
  EXPECT_EQ(labels(5), labels(5));
  EXPECT_NE(labels(5), labels(6));
}

}  // namespace
}  // namespace stope::topology
