#include "framework/compare/experiment/experiment.hpp"

#include "tests/framework/compare/files_of_test.hpp"

namespace stope {
namespace {

class ExperimentTest : public testing::FilesTest {
 protected:
  std::optional<Experiment> read_text(const std::string& text) {
    Diagnostics diagnostics;
    auto experiment = read_experiment(write("e.yaml", text), diagnostics);
    said_ = text_of(diagnostics);
    for (auto at = said_.find(folder().string()); at != std::string::npos;
         at = said_.find(folder().string()))
      said_.erase(at, folder().string().size() + 1);
    return experiment;
  }
  static std::vector<std::string> names(const std::vector<Variant>& variants) {
    std::vector<std::string> list;
    for (const Variant& variant : variants) list.push_back(variant.name);
    return list;
  }
  std::string said_;
};

using Names = std::vector<std::string>;

constexpr const char* kMetrics = "metrics: {apls: {from: score, better: higher, matters: 0.01}}\n";

TEST_F(ExperimentTest, SaysWhatIsComparedOnWhatAndByWhat) {
  const auto experiment = read_text(R"(
stope_experiment: 1
name: watershed-vs-voronoi
base: pipelines/pit.yaml
baseline: voronoi
set: {grid.min_points: 4}
arms:
  watershed: {roads.use: topology/watershed}
  voronoi: {roads.use: topology/voronoi, roads.min_clearance: 4 m}
recordings:
  pit_1: {vars.recording: data/one}
  pit_2: {vars.recording: data/two}
seeds: [3, 5]
metrics:
  apls: {from: score, measure: apls_mean, better: higher, matters: 0.01}
  worst: {from: walls.measures, better: lower, matters: 0.5 m}
timing: {pairs: 5}
)");
  ASSERT_TRUE(experiment) << said_;
  EXPECT_EQ(experiment->name, "watershed-vs-voronoi");
  EXPECT_EQ(experiment->base, folder() / "pipelines/pit.yaml");
  EXPECT_EQ(names(experiment->arms), (Names{"watershed", "voronoi"}));
  EXPECT_EQ(experiment->baseline, 1U);
  EXPECT_EQ(experiment->arms[1].overrides[1].key, "roads.min_clearance");
  EXPECT_EQ(experiment->arms[1].overrides[1].value.text, "4 m");
  EXPECT_EQ(experiment->recordings[0].overrides[0].value.folder, folder().string())
      << "paths are relative to the experiment";
  EXPECT_EQ(experiment->seeds, (std::vector<std::uint64_t>{3, 5}));
  EXPECT_EQ(experiment->metrics[0].measure, "apls_mean");
  EXPECT_EQ(experiment->metrics[1].measure, "worst") << "called as the metric";
  EXPECT_EQ(experiment->metrics[1].port, "measures");
  EXPECT_EQ(experiment->metrics[1].direction, Direction::kLower);
  EXPECT_EQ(experiment->metrics[1].smallest_that_matters.unit, "m");
  EXPECT_EQ(experiment->timing_pairs, 5);
}

TEST_F(ExperimentTest, NeedsNeitherRecordingsNorSeedsNorABaseline) {
  const auto experiment = read_text(std::string("stope_experiment: 1\nbase: pit.yaml\n"
                                                "arms: {as_it_is: , other: {a.b: 1}}\n") +
                                    kMetrics);
  ASSERT_TRUE(experiment) << said_;
  EXPECT_EQ(experiment->name, "e");
  EXPECT_TRUE(experiment->arms[0].overrides.empty());
  EXPECT_EQ(experiment->recordings.size(), 1U);
  EXPECT_EQ(experiment->seeds, (std::vector<std::uint64_t>{0}));
}

TEST_F(ExperimentTest, ACrossMakesEveryCombination) {
  const auto experiment = read_text(std::string(R"(
stope_experiment: 1
base: pit.yaml
arms:
  plain:
  cross:
    roads.use: [topology/watershed, topology/voronoi]
    width:
      narrow: {roads.min_clearance: 2 m}
      wide: {roads.min_clearance: 8 m}
recordings:
  cross: {seed: [1, 2, 3]}
)") + kMetrics);
  ASSERT_TRUE(experiment) << said_;
  EXPECT_EQ(names(experiment->arms), (Names{"plain", "watershed+narrow", "watershed+wide",
                                            "voronoi+narrow", "voronoi+wide"}));
  EXPECT_EQ(experiment->arms[4].overrides[0].value.text, "topology/voronoi");
  EXPECT_EQ(experiment->arms[4].overrides[1].value.text, "8 m");
  EXPECT_EQ(names(experiment->recordings), (Names{"seed=1", "seed=2", "seed=3"}));
  EXPECT_EQ(experiment->seed_of(2, 0), 3U);
}

TEST_F(ExperimentTest, ChoicesOfAListAreCalledByTheirValues) {
  const auto experiment = read_text(std::string("stope_experiment: 1\nbase: pit.yaml\narms:\n"
                                                "  cross: {roads.min_clearance: [2 m, 4 m], "
                                                "vars.path: [a/b, 'a b']}\n") +
                                    kMetrics);
  ASSERT_TRUE(experiment) << said_;
  EXPECT_EQ(names(experiment->arms)[0], "min_clearance=2m+path=a-b");
  EXPECT_EQ(names(experiment->arms)[3], "min_clearance=4m+path=ab");
}

TEST_F(ExperimentTest, EverythingThatIsWrongIsSaidAtOnce) {
  EXPECT_FALSE(read_text(R"(stope_experiment: 1
bse: pit.yaml
baseline: voronoy
arms:
  voronoi: {roads.use: topology/voronoi}
  water shed: {roads.use: topology/watershed}
  list: [1]
recordings:
  cross: {seed: []}
seeds: [1, one, 1]
metrics:
  apls: {from: score, beter: higher, matters: much}
  topo: {from: score, better: up, matters: -1}
timing: 5
)"));
  EXPECT_EQ(
      said_,
      "e.yaml: error[P022]: This experiment has no 'base'. Write 'base: pipeline.yaml', the "
      "pipeline that the arms vary.\n"
      "e.yaml:2:1: error[P021]: An experiment has no key 'bse'; it has 'stope_experiment', "
      "'name', 'base', 'baseline', 'set', 'arms', 'recordings', 'seeds', 'metrics' and "
      "'timing'. Did you mean 'base'?\n"
      "e.yaml:3:11: error[X002]: There is no arm 'voronoy' to be the baseline. Did you mean "
      "'voronoi'?\n"
      "e.yaml:6:3: error[P025]: 'water shed' cannot be the name of an arm. It is a folder's "
      "name too: use letters, digits, '_', '-', '.', '=' and '+'.\n"
      "e.yaml:7:9: error[P020]: The arm 'list' must be a map of what it changes, here stands "
      "a list. Write 'stage.use: family/name' or 'vars.name: value' in it.\n"
      "e.yaml:9:17: error[P020]: The axis 'seed' has no choices: here stands an empty list. "
      "Write a list of values, or a map of named choices.\n"
      "e.yaml:10:12: error[X006]: A seed is a whole number of 0 or more, not 'one'.\n"
      "e.yaml:10:17: error[X003]: The seed 1 stands here twice.\n"
      "e.yaml:12:3: error[P022]: The metric 'apls' has no 'better'. Write 'better: higher' or "
      "'better: lower'.\n"
      "e.yaml:12:23: error[P021]: A metric has no key 'beter'; it has 'from', 'measure', "
      "'better' and 'matters'. Did you mean 'better'?\n"
      "e.yaml:12:47: error[X006]: 'matters' is a number of 0 or more, such as 0.01 or 0.5 m, "
      "not 'much'.\n"
      "e.yaml:13:31: error[P020]: 'better' is 'higher' or 'lower', not 'up'.\n"
      "e.yaml:13:44: error[X006]: 'matters' is a number of 0 or more, such as 0.01 or 0.5 m, "
      "not '-1'.\n"
      "e.yaml:14:9: error[P020]: 'timing' says how many pairs of runs are timed, 1 to 1000. "
      "Write 'timing: {pairs: 5}'.\n");
}

TEST_F(ExperimentTest, OneArmIsNoComparison) {
  EXPECT_FALSE(
      read_text(std::string("stope_experiment: 1\nbase: pit.yaml\narms: {only: }\n") + kMetrics));
  EXPECT_NE(said_.find("error[X001]: There is one arm, and nothing to compare it with."),
            std::string::npos)
      << said_;
}

TEST_F(ExperimentTest, TwoArmsOfOneNameAreNamed) {
  EXPECT_FALSE(read_text(std::string("stope_experiment: 1\nbase: pit.yaml\narms:\n"
                                     "  cross: {a.b: [1 m, 1m]}\n") +
                         kMetrics));
  EXPECT_NE(said_.find("error[X003]: Two arms are called 'b=1m'"), std::string::npos) << said_;
}

TEST_F(ExperimentTest, SeedsAreSaidInOnePlace) {
  EXPECT_FALSE(read_text(std::string("stope_experiment: 1\nbase: pit.yaml\narms: {a: , b: }\n"
                                     "recordings: {one: {seed: 1}}\nseeds: [1, 2]\n") +
                         kMetrics));
  EXPECT_NE(said_.find("error[X004]: The recording 'one' sets the run's seed itself"),
            std::string::npos)
      << said_;
}

TEST_F(ExperimentTest, APipelineIsNoExperiment) {
  EXPECT_FALSE(read_text("stope: 1\nstages: {}\n"));
  EXPECT_EQ(said_,
            "e.yaml: error[P022]: This is a pipeline, not an experiment. An experiment begins with "
            "'stope_experiment: 1' and names the pipeline under 'base:'.\n");
  EXPECT_FALSE(read_text("stope_experiment: 2\nvariants: []\n"));
  EXPECT_EQ(said_,
            "e.yaml:1:19: error[P023]: This Stope reads version 1 of experiment files. Write "
            "'stope_experiment: 1'.\n");
}

TEST_F(ExperimentTest, WhatIsEmptyIsSaidToBe) {
  EXPECT_FALSE(
      read_text("stope_experiment: 1\nbase: pit.yaml\narms: {}\nrecordings: {}\n"
                "seeds: []\nmetrics: {}\n"));
  EXPECT_EQ(said_,
            "e.yaml:3:7: error[P020]: 'arms' names no arm. Write 'name: {stage.parameter: "
            "value}'.\n"
            "e.yaml:4:13: error[P020]: 'recordings' names no recording. Write 'name: "
            "{stage.parameter: value}'.\n"
            "e.yaml:5:8: error[P020]: 'seeds' must be a list, here stands one without a seed. "
            "Write 'seeds: [1, 2, 3]', or leave it out.\n"
            "e.yaml:6:10: error[P020]: 'metrics' names no metric. Write 'name: {from: stage, "
            "better: higher, matters: 0.01}'.\n");
  EXPECT_FALSE(read_text(std::string("stope_experiment: 1\nbase: pit.yaml\narms: []\n"
                                     "recordings: [one]\n") +
                         kMetrics));
  EXPECT_EQ(said_,
            "e.yaml:3:7: error[P020]: 'arms' must be a map, here stands a list. Write 'name: "
            "{stage.parameter: value}'.\n"
            "e.yaml:4:13: error[P020]: 'recordings' must be a map, here stands a list. Write "
            "'name: {stage.parameter: value}'.\n");
}

TEST_F(ExperimentTest, ANameThatStandsTwiceIsAllThatIsSaidOfIt) {
  EXPECT_FALSE(read_text(std::string("stope_experiment: 1\nbase: pit.yaml\n"
                                     "arms: {one: , one: {a.b: 1}}\n"
                                     "recordings: {pit: {seed: 1}, pit: {seed: 2}}\n") +
                         kMetrics));
  EXPECT_EQ(said_,
            "e.yaml:3:15: error[P007]: The key 'one' stands here a second time; the first is at "
            "e.yaml:3:8. Remove one of them.\n"
            "e.yaml:4:30: error[P007]: The key 'pit' stands here a second time; the first is at "
            "e.yaml:4:14. Remove one of them.\n");
}

TEST_F(ExperimentTest, CrossesEnd) {
  std::string axes;
  for (char axis = 'a'; axis < 'k'; ++axis)
    axes += std::string(axis == 'a' ? "" : ", ") + axis + ".x: [1, 2, 3]";
  EXPECT_FALSE(
      read_text("stope_experiment: 1\nbase: pit.yaml\narms: {cross: {" + axes + "}}\n" + kMetrics));
  EXPECT_NE(said_.find("error[X005]: This cross makes more than 1000 arms."), std::string::npos)
      << said_;
}

}  // namespace
}  // namespace stope
