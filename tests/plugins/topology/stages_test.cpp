#include <gtest/gtest.h>

#include "stope/plugin.hpp"
#include "stope/stope.hpp"
#include "stope/testing/memory_context.hpp"
#include "stope/testing/memory_ports.hpp"
#include "tests/plugins/topology/test_grids.hpp"

extern "C" const stope::StageEntry* stope_stage_Watershed();
extern "C" const stope::StageEntry* stope_stage_Voronoi();

namespace stope::topology {
namespace {

StageInfo info_of(const StageEntry& entry) {
  StageInfo info;
  EXPECT_TRUE(entry.describe(info));
  return info;
}

TEST(Stages, AreInterchangeable) {
  const StageInfo watershed = info_of(*stope_stage_Watershed());
  const StageInfo voronoi = info_of(*stope_stage_Voronoi());
  EXPECT_EQ(watershed.id, "topology/watershed");
  EXPECT_EQ(voronoi.id, "topology/voronoi");
  for (const StageInfo& info : {watershed, voronoi}) {
    ASSERT_EQ(info.inputs.size(), 1U);
    EXPECT_EQ(info.inputs[0].name, "grid");
    EXPECT_EQ(info.inputs[0].type, "stope/OccupancyGrid@1");
    ASSERT_EQ(info.outputs.size(), 1U);
    EXPECT_EQ(info.outputs[0].name, "roads");
    EXPECT_EQ(info.outputs[0].type, "stope/RoadGraph@1");
  }
  // What watershed can be told, voronoi can be told as well.
  ASSERT_LE(watershed.parameters.size(), voronoi.parameters.size());
  for (std::size_t i = 0; i < watershed.parameters.size(); ++i)
    EXPECT_EQ(watershed.parameters[i].name, voronoi.parameters[i].name);
}

TEST(Stages, WatershedSaysThatDeadEndsAreLost) {
  EXPECT_NE(info_of(*stope_stage_Watershed()).notes.find("dead ends"), std::string::npos);
}

}  // namespace
}  // namespace stope::topology
