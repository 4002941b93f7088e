#include <gtest/gtest.h>

#include "checked.hpp"

namespace stope {
namespace {

const char* const kQuickstart = R"(
stope: 1
name: quickstart
vars:
  road_width: 16 m
stages:
  scans: {use: source/synthetic_pit}
  cloud: {use: map/point_cloud, in: {scans: scans.scans, trajectory: scans.trajectory}}
  live:  {use: rasterizer/height_difference, in: cloud}
  prior: {use: prior/trajectory_dilation, in: scans.trajectory, params: {width: "${road_width}"}}
  grid:  {use: fusion/maximum, in: {prior: prior, live: live}}
  roads: {use: topology/watershed, in: grid, params: {min_clearance: 250 cm}}
  plan:  {use: planner/a_star, in: {roads: roads, grid: grid}, params: {goal: [0.1 km, -3]}}
outputs:
  map.yaml: grid
  roads.geojson: roads
  plan.geojson: plan
  trajectory.tum: scans.trajectory
  pictures/overview.png: {use: export/png, in: {grid: grid, roads: roads, path: plan}}
)";

TEST(Check, PlansAWholePipeline) {
  const Checked checked = check_text(kQuickstart);
  ASSERT_TRUE(checked.plan) << checked.text;
  EXPECT_EQ(checked.text, "");
  EXPECT_EQ(checked.plan->name, "quickstart");
  EXPECT_EQ(checked.plan->vars.at("road_width"), "16 m");
  EXPECT_EQ(checked.plan->stages.size(), 12U);
  EXPECT_EQ(checked.source("cloud", "trajectory"), "scans.trajectory");
  EXPECT_EQ(checked.source("plan", "grid"), "grid.grid");
  EXPECT_EQ(std::get<double>(checked.parameter("prior", "width")), 16.0);
  EXPECT_EQ(std::get<double>(checked.parameter("roads", "min_clearance")), 2.5);
  EXPECT_EQ(std::get<std::vector<double>>(checked.parameter("plan", "goal")),
            (std::vector<double>{100, -3}));
  EXPECT_TRUE(std::holds_alternative<std::monostate>(checked.parameter("plan", "start")));
}

TEST(Check, PutsStagesAfterWhatTheyRead) {
  const Checked checked = check_text(R"(
stope: 1
stages:
  roads: {use: topology/watershed, in: live}
  live:  {use: rasterizer/drivable, in: cloud}
  cloud: {use: map/point_cloud, in: {scans: pit, trajectory: pit}}
  pit:   {use: source/synthetic_pit}
outputs: {roads.graphml: roads}
)");
  ASSERT_TRUE(checked.plan) << checked.text;
  std::vector<std::string> names;
  for (const PlannedStage& stage : checked.plan->stages) names.push_back(stage.name);
  EXPECT_EQ(names,
            (std::vector<std::string>{"pit", "cloud", "live", "roads", "outputs/roads.graphml"}));
  EXPECT_EQ(checked.source("cloud", "scans"), "pit.scans");
  EXPECT_EQ(checked.source("cloud", "trajectory"), "pit.trajectory");
}

TEST(Check, AMapGivesAStreamIfItReadsOne) {
  const Checked checked = check_text(R"(
stope: 1
stages:
  pit:    {use: source/synthetic_pit}
  clouds: {use: filter/range, in: pit}
  live:   {use: rasterizer/drivable, in: clouds}
  cloud:  {use: map/point_cloud, in: {scans: pit, trajectory: pit}}
  joined: {use: rasterizer/drivable, in: cloud}
outputs: {live.png: live, joined.png: joined}
)");
  ASSERT_TRUE(checked.plan) << checked.text;
  EXPECT_TRUE(checked.stage("live").streams.at(0));
  EXPECT_FALSE(checked.stage("joined").streams.at(0));
  EXPECT_TRUE(checked.plan->outputs.at(0).stream);
  EXPECT_FALSE(checked.plan->outputs.at(1).stream);
}

TEST(Check, ExportsAreChosenByExtensionAndType) {
  const Checked checked = check_text(kQuickstart);
  ASSERT_TRUE(checked.plan) << checked.text;
  EXPECT_EQ(checked.stage("outputs/roads.geojson").info.id, "export/nav2_route");
  EXPECT_EQ(checked.stage("outputs/plan.geojson").info.id, "export/path");
  EXPECT_TRUE(checked.stage("outputs/plan.geojson").is_export);
  EXPECT_EQ(checked.source("outputs/pictures/overview.png", "path"), "plan.path");
  EXPECT_EQ(checked.plan->outputs.at(4).name, "pictures/overview.png");
}

TEST(Check, TheLongestExtensionCounts) {
  const Checked checked = check_text(R"(
stope: 1
stages:
  pit:   {use: source/synthetic_pit}
  cloud: {use: map/point_cloud, in: {scans: pit, trajectory: pit}}
  grid:  {use: rasterizer/drivable, in: cloud}
outputs: {pit.2024.pcd.gz: cloud, pit.2024.pcd: cloud, maps/pit.2024.yaml: grid}
)");
  ASSERT_TRUE(checked.plan) << checked.text;
  EXPECT_EQ(checked.stage("outputs/pit.2024.pcd.gz").info.id, "export/packed");
  EXPECT_EQ(checked.stage("outputs/pit.2024.pcd").info.id, "export/pcd");
  EXPECT_EQ(std::get<std::string>(checked.parameter("outputs/maps/pit.2024.yaml", "stem")),
            "pit.2024");
}

TEST(Check, SetChangesParametersVariablesAndStages) {
  const Checked checked = check_text(
      kQuickstart, {"roads.use=topology/voronoi", "roads.prune=3", "vars.road_width=1200 cm",
                    "plan.start=[1, 2 m]", "grid.in={prior: live, live: prior}"});
  ASSERT_TRUE(checked.plan) << checked.text;
  EXPECT_EQ(checked.stage("roads").info.id, "topology/voronoi");
  EXPECT_EQ(std::get<double>(checked.parameter("roads", "prune")), 3.0);
  EXPECT_EQ(std::get<double>(checked.parameter("prior", "width")), 12.0);
  EXPECT_EQ(std::get<std::vector<double>>(checked.parameter("plan", "start")),
            (std::vector<double>{1, 2}));
  EXPECT_EQ(checked.source("grid", "prior"), "live.grid");
}

TEST(Check, AnOutputMayGiveItsExportParameters) {
  const Checked checked = check_text(R"(
stope: 1
stages:
  pit:  {use: source/synthetic_pit}
  grid: {use: prior/trajectory_dilation, in: pit}
outputs:
  raw.yaml: {in: grid, params: {mode: raw}}
  named.yaml: {use: export/map_server, in: grid, params: {stem: mine}}
)");
  ASSERT_TRUE(checked.plan) << checked.text;
  EXPECT_EQ(std::get<std::string>(checked.parameter("outputs/raw.yaml", "mode")), "raw");
  EXPECT_EQ(std::get<std::string>(checked.parameter("outputs/raw.yaml", "stem")), "raw");
  EXPECT_EQ(std::get<std::string>(checked.parameter("outputs/named.yaml", "stem")), "mine");
}

TEST(Check, SetSaysWhichOptionIsWrong) {
  const Checked checked =
      check_text(kQuickstart, {"roads.min_clearance=1", "roads.min_cleerance=1"});
  EXPECT_FALSE(checked.plan);
  EXPECT_EQ(checked.text,
            "--set:2: error[P070]: topology/watershed has no parameter 'min_cleerance'; it has "
            "'min_clearance'. Did you mean 'min_clearance'?\n");
}

}  // namespace
}  // namespace stope
