#include <gtest/gtest.h>

#include "stope/plugin.hpp"
#include "stope/stope.hpp"
#include "stope/testing/memory_context.hpp"
#include "stope/testing/memory_ports.hpp"

namespace stope {
namespace {

class Thicken final : public Map<OccupancyGrid(OccupancyGrid, Optional<DistanceGrid>)> {
 public:
  struct Params {
    double radius = 2.0;
    std::optional<int> limit;
  } params;
  static void describe(About<Thicken>& about) {
    about.summary("Thickens obstacles.")
        .ports("grid", "distance", "grid")
        .param("radius", &Params::radius, "m", at_least(0.0), "How far.")
        .param("limit", &Params::limit, "Most cells.");
  }
  OccupancyGrid apply(const OccupancyGrid& grid, const Optional<DistanceGrid>& distance,
                      Context&) const {
    OccupancyGrid result = grid;
    result.frame.resolution = distance ? 1.0 : params.radius;
    return result;
  }
};

class Count final : public Stage {
 public:
  struct Params {
  } params;
  In<LidarScan> scans;
  OutValue<Measures> measures;
  static void describe(About<Count>& about) {
    about.summary("Counts scans.")
        .input("scans", &Count::scans)
        .output("measures", &Count::measures);
  }
  void run(Context&) override {
    double count = 0;
    while (auto scan = scans.next()) count += static_cast<double>(scan->points.size());
    if (count == 0) throw Error("there was no scan");
    measures.set({{"points"}, {count}, {""}, {""}});
  }
};

/// Reads a file beside the one it is told of.
class Atlas final : public Stage {
 public:
  struct Params {
    std::filesystem::path sheet;
  } params;
  static void describe(About<Atlas>& about) {
    about.summary("Reads a sheet and its legend.").param("sheet", &Params::sheet, "The sheet.");
  }
  std::vector<std::filesystem::path> also_reads() const {
    if (!params.sheet.has_filename()) throw Error("the sheet has no name");
    return {params.sheet.parent_path() / "legend"};
  }
  void run(Context&) override {}
};

TEST(Stage, NamesTheFilesThatItAlsoReads) {
  StageInfo info;
  ASSERT_TRUE(stage_entry<Atlas>("test/atlas").describe(info));
  EXPECT_TRUE(info.also_reads);
  InstanceOf<Atlas> atlas("test/atlas");
  EXPECT_TRUE(atlas.info().also_reads);
  ASSERT_TRUE(atlas.set_parameter(0, std::string("/maps/north")));
  std::vector<std::filesystem::path> paths;
  ASSERT_TRUE(atlas.also_reads(paths));
  EXPECT_EQ(paths, (std::vector<std::filesystem::path>{"/maps/legend"}));
  ASSERT_TRUE(atlas.set_parameter(0, std::string("/maps/")));
  EXPECT_EQ(atlas.also_reads(paths).sentence, "the sheet has no name");
}

TEST(Stage, AlsoReadsNothingIfItDoesNotSaySo) {
  const InstanceOf<Count> count("test/count");
  EXPECT_FALSE(count.info().also_reads);
  std::vector<std::filesystem::path> paths;
  EXPECT_TRUE(count.also_reads(paths));
  EXPECT_TRUE(paths.empty());
}

TEST(Stage, DeclaresItselfWithoutBeingMade) {
  StageInfo info;
  ASSERT_TRUE(stage_entry<Thicken>("test/thicken").describe(info));
  EXPECT_EQ(info.id, "test/thicken");
  EXPECT_TRUE(info.map);
  ASSERT_EQ(info.inputs.size(), 2U);
  EXPECT_FALSE(info.inputs[1].required);
  EXPECT_EQ(info.outputs[0].type, "stope/OccupancyGrid@1");
  EXPECT_EQ(std::get<double>(info.parameters[0].default_value), 2.0);
  EXPECT_TRUE(info.parameters[1].optional);
}

TEST(Stage, AnIntegerParameterAcceptsWhatItsMemberHolds) {
  StageInfo info;
  ASSERT_TRUE(stage_entry<Thicken>("test/thicken").describe(info));
  EXPECT_EQ(info.parameters[1].limits.least, -2147483648.0);
  EXPECT_EQ(info.parameters[1].limits.most, 2147483647.0);
}

TEST(Stage, AMapIsAppliedThroughItsInstance) {
  InstanceOf<Thicken> instance("test/thicken");
  ASSERT_TRUE(instance.set_parameter(0, 3.5));
  ::stope::testing::MemoryContext context;
  OccupancyGrid grid;
  grid.cells = {1};
  auto value = std::make_shared<const OccupancyGrid>(grid);
  const AnyItem inputs[] = {
      {0, 0, std::make_shared<::stope::testing::MemoryPayload<OccupancyGrid>>(value)}, {}};
  std::shared_ptr<const void> output[1];
  ASSERT_TRUE(instance.apply(inputs, context, output));
  EXPECT_EQ(static_cast<const OccupancyGrid*>(output[0].get())->frame.resolution, 3.5);
}

TEST(Stage, AStageRunsThroughItsInstance) {
  InstanceOf<Count> instance("test/count");
  ::stope::testing::MemoryInput<LidarScan> input;
  ::stope::testing::MemoryOutput<Measures> output;
  LidarScan scan;
  scan.points.resize(3);
  input.add(1, scan);
  input.add(2, scan);
  instance.connect_input(0, &input);
  instance.connect_output(0, &output);
  ::stope::testing::MemoryContext context;
  ASSERT_TRUE(instance.run(context));
  ASSERT_EQ(output.items.size(), 1U);
  EXPECT_EQ(output.items[0].value->values[0], 6);
}

TEST(Stage, AThrownErrorBecomesAnOutcome) {
  InstanceOf<Count> instance("test/count");
  ::stope::testing::MemoryContext context;
  const Outcome outcome = instance.run(context);
  EXPECT_EQ(outcome.kind, Outcome::Kind::kFailed);
  EXPECT_EQ(outcome.sentence, "there was no scan");
}

}  // namespace
}  // namespace stope
