#include <gtest/gtest.h>

#include <cmath>

#include "plugins/topology/extract_roads.hpp"
#include "stope/plugin.hpp"
#include "stope/stope.hpp"
#include "tests/plugins/stage_harness.hpp"
#include "tests/plugins/topology/test_grids.hpp"

extern "C" const stope::StageEntry* stope_stage_Watershed();
extern "C" const stope::StageEntry* stope_stage_Voronoi();
extern "C" const stope::StageEntry* stope_stage_Skeleton();

namespace stope::topology {
namespace {

using stope::testing::error_of;
using stope::testing::StageHarness;

StageInfo info_of(const StageEntry& entry) {
  StageInfo info;
  EXPECT_TRUE(entry.describe(info));
  return info;
}

std::vector<const StageEntry*> members() {
  return {stope_stage_Watershed(), stope_stage_Voronoi(), stope_stage_Skeleton()};
}

TEST(Stages, AreInterchangeable) {
  EXPECT_EQ(info_of(*stope_stage_Watershed()).id, "topology/watershed");
  EXPECT_EQ(info_of(*stope_stage_Voronoi()).id, "topology/voronoi");
  EXPECT_EQ(info_of(*stope_stage_Skeleton()).id, "topology/skeleton");
  for (const StageEntry* entry : members()) {
    const StageInfo info = info_of(*entry);
    ASSERT_EQ(info.inputs.size(), 2U);
    EXPECT_EQ(info.inputs[0].name, "grid");
    EXPECT_EQ(info.inputs[0].type, "stope/OccupancyGrid@1");
    EXPECT_EQ(info.inputs[1].name, "elevation");
    EXPECT_EQ(info.inputs[1].type, "stope/ElevationGrid@1");
    EXPECT_FALSE(info.inputs[1].required);
    ASSERT_EQ(info.outputs.size(), 1U);
    EXPECT_EQ(info.outputs[0].name, "roads");
    EXPECT_EQ(info.outputs[0].type, "stope/RoadGraph@2");
  }
}

// A pipeline that tells voronoi something can put any other member in its place.
TEST(Stages, WhatVoronoiCanBeToldTheOthersCanBeToldAsWell) {
  const StageInfo voronoi = info_of(*stope_stage_Voronoi());
  for (const StageEntry* entry : members()) {
    const StageInfo info = info_of(*entry);
    ASSERT_LE(voronoi.parameters.size(), info.parameters.size());
    for (std::size_t i = 0; i < voronoi.parameters.size(); ++i) {
      EXPECT_EQ(voronoi.parameters[i].name, info.parameters[i].name);
      EXPECT_EQ(voronoi.parameters[i].default_value, info.parameters[i].default_value);
    }
  }
}

TEST(Stages, WatershedSaysThatDeadEndsAreLost) {
  EXPECT_NE(info_of(*stope_stage_Watershed()).notes.find("dead ends"), std::string::npos);
}

// A yard of 31 x 31 m: one place, no road.
OccupancyGrid yard() { return grid_of(std::vector<std::string>(31, std::string(31, '.'))); }

// A yard with a block of 9 x 9 m in its middle.
OccupancyGrid yard_with_block() {
  return grid_where(31, 31, 1, [](double x, double y) {
    return std::abs(x - 15.5) > 4.5 || std::abs(y - 15.5) > 4.5;
  });
}

TEST(Stages, AGraphWithoutRoadsIsAnErrorThatSaysWhatToDo) {
  const std::string watershed = error_of(
      [] { StageHarness(stope_stage_Watershed()).input("grid", yard()).apply<RoadGraph>(); });
  for (const char* part : {"at least one obstacle or hole inside the free space",
                           "min_obstacle_area (10 m^2)", "topology/voronoi", "allow_empty"})
    EXPECT_NE(watershed.find(part), std::string::npos) << watershed;
  StageHarness parts(stope_stage_Watershed()), voronoi(stope_stage_Voronoi()),
      skeleton(stope_stage_Skeleton());
  parts.set("sites", std::string("outline_parts"));
  for (StageHarness* stage : {&parts, &voronoi, &skeleton}) {
    const std::string sentence = error_of([&] { stage->input("grid", yard()).apply<RoadGraph>(); });
    for (const char* part : {"min_clearance (2 m)", "min_branch (4 m)", "allow_empty"})
      EXPECT_NE(sentence.find(part), std::string::npos) << sentence;
  }
}

TEST(Stages, AnObstacleTooSmallToCountMakesNoRoad) {
  StageHarness stage(stope_stage_Watershed());
  stage.input("grid", yard_with_block());
  EXPECT_EQ(stage.apply<RoadGraph>().edges.size(), 1U);
  stage.set("min_obstacle_area", 100.0);
  EXPECT_NE(error_of([&] { stage.apply<RoadGraph>(); }).find("min_obstacle_area (100 m^2)"),
            std::string::npos);
}

TEST(Stages, AllowEmptyGivesTheEmptyGraphAndSaysSo) {
  for (const StageEntry* entry : members()) {
    StageHarness stage(entry);
    stage.set("allow_empty", true).input("grid", yard());
    EXPECT_TRUE(stage.apply<RoadGraph>().edges.empty());
    ASSERT_EQ(stage.context().sentences.size(), 1U);
    EXPECT_NE(stage.context().sentences[0].find("no road that can be extracted"),
              std::string::npos);
  }
}

TEST(Stages, WithoutAFreeCellTheyFailEvenIfEmptyIsAllowed) {
  for (const StageEntry* entry : members()) {
    StageHarness stage(entry);
    stage.set("allow_empty", true).input("grid", grid_of({"###", "###"}));
    EXPECT_NE(error_of([&] { stage.apply<RoadGraph>(); }).find("no free cell"), std::string::npos);
  }
}

TEST(Stages, GiveUpWhenTheRunIsCancelled) {
  for (const StageEntry* entry : members()) {
    StageHarness stage(entry);
    stage.input("grid", yard_with_block()).context().cancel = true;
    EXPECT_THROW(stage.apply<RoadGraph>(), Cancelled);
  }
}

// Wherever the computation asks, it can be stopped, and what it asks does not change the roads.
TEST(Stages, TheComputationCanBeStoppedAtEveryCheckpoint) {
  const OccupancyGrid grid = yard_with_block();
  const auto stopped_after = [&](int calls) {
    int left = calls;
    const auto checkpoint = [&] {
      if (left-- == 0) throw Cancelled();
    };
    try {
      EXPECT_EQ(voronoi_roads(grid, {}, {}, checkpoint).vertices.size(),
                voronoi_roads(grid, {}, {}).vertices.size());
      return false;
    } catch (const Cancelled&) {
      return true;
    }
  };
  int calls = 0;
  while (stopped_after(calls)) ++calls;
  EXPECT_GE(calls, 10);
}

}  // namespace
}  // namespace stope::topology
