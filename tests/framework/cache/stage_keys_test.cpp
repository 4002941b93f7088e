#include "framework/cache/stage_keys.hpp"

#include <gtest/gtest.h>

#include <set>

#include "framework/cache/file_digests.hpp"
#include "stope/stope.hpp"

namespace stope {
namespace {

/// Reads a file beside the one it is told of; its value is the file's folder.
class Atlas final : public Stage {
 public:
  struct Params {
    std::string value;
  } params;
  OutValue<OccupancyGrid> grid;
  static void describe(About<Atlas>& about) {
    about.output("grid", &Atlas::grid).param("value", &Params::value, "Where the legend is.");
  }
  std::vector<std::filesystem::path> also_reads() const {
    if (params.value.empty()) throw Error("the atlas has no folder");
    return {params.value + "/legend", params.value + "/sheet"};
  }
  void run(Context&) override {}
};

/// Stages that are there by name and build; all are made as an Atlas.
class Builds final : public Catalogue {
 public:
  void add(const StageInfo& info, std::string build) {
    stages_.push_back({info, {}, "toy", "1", std::move(build)});
  }
  void rebuild(std::string_view id) {
    for (StageRecord& stage : stages_)
      if (stage.info.id == id) stage.build_id += "+";
  }
  const std::vector<StageRecord>& stages() const override { return stages_; }
  const StageRecord* find(std::string_view id) const override {
    for (const StageRecord& stage : stages_)
      if (stage.info.id == id) return &stage;
    return nullptr;
  }
  std::unique_ptr<StageInstance> create(std::string_view id) const override {
    return std::make_unique<InstanceOf<Atlas>>(std::string(id));
  }

 private:
  std::vector<StageRecord> stages_;
};

/// scans -> grid -> roads, and log, which reads scans beside them.
class StageKeysTest : public ::testing::Test {
 protected:
  enum : std::size_t { kScans, kGrid, kRoads, kLog };

  StageKeysTest() {
    PlannedStage scans = stage("scans", "source/pcd", {}, {"/data/mine"});
    scans.info.parameters[0].kind = ParameterKind::kPath;
    plan_.stages = {scans, stage("grid", "rasterizer/height", {PlannedSource{kScans, 0}}, {0.5}),
                    stage("roads", "topology/voronoi", {PlannedSource{kGrid, 0}}, {2.0}),
                    stage("log", "metric/count", {PlannedSource{kScans, 0}}, {true})};
    for (const PlannedStage& stage : plan_.stages) builds_.add(stage.info, "b1");
    facts_.run = "first";
    facts_.digest_of_path = [this](const std::filesystem::path& path) {
      return digest_of(path.string() == "/data/mine" ? content_ : std::string());
    };
  }

  static PlannedStage stage(std::string name, std::string id, std::vector<PlannedSource> inputs,
                            ParameterValue value) {
    PlannedStage stage;
    stage.name = std::move(name);
    stage.info.id = std::move(id);
    for (const PlannedSource& source : inputs) {
      stage.info.inputs.push_back(traits::port_info<OccupancyGrid>("grid", true, true, ""));
      stage.inputs.push_back(source);
    }
    stage.info.outputs = {traits::port_info<OccupancyGrid>("grid", true, true, "")};
    stage.streams = {true};
    stage.info.parameters.resize(1);
    stage.info.parameters[0].name = "value";
    stage.parameters = {std::move(value)};
    return stage;
  }

  std::vector<StageKey> keys() const { return stage_keys(plan_, builds_, facts_); }
  /// The stages whose key differs from the one before `change`.
  std::set<std::string> changed_by(const std::function<void()>& change) {
    const std::vector<StageKey> before = keys();
    change();
    const std::vector<StageKey> now = keys();
    std::set<std::string> changed;
    for (std::size_t i = 0; i < now.size(); ++i)
      if (now[i].digest != before[i].digest) changed.insert(plan_.stages[i].name);
    return changed;
  }

  Plan plan_;
  Builds builds_;
  KeyFacts facts_;
  std::string content_ = "scans of Monday";
};

using Names = std::set<std::string>;

TEST_F(StageKeysTest, StayWhileNothingChanges) {
  EXPECT_EQ(changed_by([] {}), Names{});
}

TEST_F(StageKeysTest, AParameterChangesItsStageAndWhatIsBelow) {
  EXPECT_EQ(changed_by([&] { plan_.stages[kGrid].parameters[0] = 0.1; }), (Names{"grid", "roads"}));
  EXPECT_EQ(changed_by([&] { plan_.stages[kRoads].parameters[0] = 2.0000000000000004; }),
            Names{"roads"});
}

TEST_F(StageKeysTest, AFilesContentCountsNotItsName) {
  EXPECT_EQ(changed_by([&] { content_ = "scans of Tuesday"; }),
            (Names{"scans", "grid", "roads", "log"}));
  const auto same = digest_of(content_);
  facts_.digest_of_path = [same](const std::filesystem::path&) { return same; };
  EXPECT_EQ(changed_by([&] { plan_.stages[kScans].parameters[0] = std::string("/moved"); }),
            Names{});
}

TEST_F(StageKeysTest, ARebuiltPluginChangesItsStages) {
  EXPECT_EQ(changed_by([&] { builds_.rebuild("topology/voronoi"); }), Names{"roads"});
}

TEST_F(StageKeysTest, ARebuiltSdkChangesAll) {
  EXPECT_EQ(changed_by([&] { facts_.sdk = "newer"; }).size(), 4U);
}

TEST_F(StageKeysTest, AnotherMemberWithTheSameParametersIsAnotherStage) {
  EXPECT_EQ(changed_by([&] {
              plan_.stages[kRoads].info.id = "topology/watershed";
              builds_.add(plan_.stages[kRoads].info, "b1");
            }),
            Names{"roads"});
}

TEST_F(StageKeysTest, TheSeedChangesAll) {
  EXPECT_EQ(changed_by([&] { facts_.seed = 2; }).size(), 4U);
}

TEST_F(StageKeysTest, APayloadsLayoutCounts) {
  EXPECT_EQ(changed_by([&] { plan_.stages[kGrid].info.outputs[0].layout ^= 1; }),
            (Names{"grid", "roads"}));
}

TEST_F(StageKeysTest, WhatMayDifferEachTimeIsKeyedByTheRunWithAllBelow) {
  plan_.stages[kGrid].info.deterministic = false;
  EXPECT_EQ(changed_by([&] { facts_.run = "second"; }), (Names{"grid", "roads"}));
  EXPECT_TRUE(keys()[kRoads].only_this_run);
  EXPECT_FALSE(keys()[kLog].only_this_run);
}

TEST_F(StageKeysTest, TextsCannotPassForOneAnother) {
  plan_.stages[kLog].parameters[0] = std::vector<std::string>{"a", "b"};
  const Digest two = keys()[kLog].digest;
  plan_.stages[kLog].parameters[0] = std::vector<std::string>{"a\" 1:\"b"};
  EXPECT_NE(keys()[kLog].digest, two);
}

TEST_F(StageKeysTest, AFileThatAStageAlsoReadsCounts) {
  std::string legend = "red: road";
  facts_.digest_of_path = [&](const std::filesystem::path& path) {
    return digest_of(path == "/maps/legend" ? legend : path.string());
  };
  plan_.stages[kLog].parameters[0] = std::string("/maps");
  EXPECT_EQ(changed_by([&] { plan_.stages[kLog].info.also_reads = true; }), Names{"log"});
  const StageKey before = keys()[kLog];
  EXPECT_EQ(changed_by([&] { legend = "red: wall"; }), Names{"log"});
  EXPECT_EQ(differences(before, keys()[kLog]),
            (std::vector<std::string>{"further file 1 was legend, content " +
                                      digest_of(std::string("red: road")).text() +
                                      ", is legend, content " + digest_of(legend).text()}));
}

TEST_F(StageKeysTest, AFileThatIsNotThereIsSaidNotToBe) {
  const StageKey before = keys()[kScans];
  facts_.digest_of_path = [](const std::filesystem::path&) { return kNothingThere; };
  EXPECT_EQ(differences(before, keys()[kScans]),
            (std::vector<std::string>{"parameter value was content " + digest_of(content_).text() +
                                      ", is nothing there"}));
}

TEST_F(StageKeysTest, TellsTheFilesItWasMadeOf) {
  plan_.stages[kLog].info.also_reads = true;
  plan_.stages[kLog].parameters[0] = std::string("/maps");
  using Paths = std::vector<std::filesystem::path>;
  EXPECT_EQ(keys()[kScans].files, (Paths{"/data/mine"}));
  EXPECT_EQ(keys()[kGrid].files, Paths{});
  EXPECT_EQ(keys()[kLog].files, (Paths{"/maps/legend", "/maps/sheet"}));
}

TEST_F(StageKeysTest, WhatCannotBeReadIsKeyedByTheRun) {
  plan_.stages[kLog].info.also_reads = true;
  plan_.stages[kLog].parameters[0] = std::string();
  EXPECT_TRUE(keys()[kLog].only_this_run);
  EXPECT_FALSE(keys()[kScans].only_this_run);
  facts_.digest_of_path = [](const std::filesystem::path&) -> Digest {
    throw Error("the disk is gone");
  };
  EXPECT_TRUE(keys()[kScans].only_this_run);
  EXPECT_TRUE(keys()[kRoads].only_this_run);
}

TEST_F(StageKeysTest, SayWhatIsDifferent) {
  const StageKey before = keys()[kGrid];
  plan_.stages[kGrid].parameters[0] = 0.1;
  content_ = "scans of Tuesday";
  EXPECT_EQ(
      differences(before, keys()[kGrid]),
      (std::vector<std::string>{"parameter value was 0.5, is 0.1", "input grid has changed"}));
}

}  // namespace
}  // namespace stope
