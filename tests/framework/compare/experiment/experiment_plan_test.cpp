#include "framework/compare/experiment/experiment_plan.hpp"

#include "tests/framework/compare/files_of_test.hpp"
#include "tests/framework/compare/toy_arms.hpp"

namespace stope {
namespace {

class ExperimentPlanTest : public testing::FilesTest {
 protected:
  std::optional<ExperimentPlan> plan(const std::string& rest) {
    write("pit.yaml", toy::kPipeline);
    Diagnostics diagnostics;
    const auto experiment = read_experiment(
        write("e.yaml", "stope_experiment: 1\nbase: pit.yaml\n" + rest), diagnostics);
    std::optional<ExperimentPlan> made;
    if (experiment) made = plan_experiment(*experiment, catalogue_, diagnostics);
    said_ = text_of(diagnostics);
    return made;
  }
  bool said(const std::string& text) const { return said_.find(text) != std::string::npos; }

  toy::ArmsCatalogue catalogue_;
  std::string said_;
};

constexpr const char* kMetric = "metrics: {mean: {from: mean, better: higher, matters: 0.1 m}}\n";

TEST_F(ExperimentPlanTest, EachArmOnEachRecordingIsAPipeline) {
  const auto made =
      plan(std::string("arms: {one: {change.factor: 1}, two: {change.factor: 2}}\n"
                       "recordings: {few: {draw.count: 2}, many: {draw.count: 9}}\n") +
           kMetric);
  ASSERT_TRUE(made) << said_;
  const Plan& plan = *made->of(1, 0).plan;
  EXPECT_EQ(plan.stages[0].parameters[0], ParameterValue(std::int64_t{2}));
  EXPECT_EQ(plan.stages[1].parameters[0], ParameterValue(2.0));
  EXPECT_EQ(plan.stages[made->of(1, 0).metrics[0].stage].name, "mean");
}

TEST_F(ExperimentPlanTest, ErrorsNameTheArmAndThePlaceInTheExperiment) {
  EXPECT_FALSE(plan(
      std::string("arms:\n  one: {chnge.factor: 1}\n  two: {change.use: toy/skale}\n") + kMetric));
  EXPECT_TRUE(
      said("e.yaml:4:9: error[P046]: In arm 'one': The pipeline has no stage 'chnge'. Did "
           "you mean 'change'?"))
      << said_;
  EXPECT_TRUE(said("e.yaml:5:21: error[P050]: In arm 'two': ")) << said_;
}

TEST_F(ExperimentPlanTest, WhatIsWrongInAllArmsIsSaidOnceWithoutThem) {
  EXPECT_FALSE(
      plan(std::string("set: {draw.cont: 1}\narms: {one: , two: {change.factor: 2}}\n") + kMetric));
  EXPECT_TRUE(said("e.yaml:3:7: error[P070]: toy/draw has no parameter 'cont'")) << said_;
  EXPECT_EQ(said_.find("error["), said_.rfind("error[")) << said_;
}

TEST_F(ExperimentPlanTest, AMetricsStageMustBeThereAndMeasure) {
  EXPECT_FALSE(
      plan("arms: {one: , two: {change.factor: 2}}\nmetrics:\n"
           "  a: {from: meen, better: higher, matters: 0}\n"
           "  b: {from: change, better: higher, matters: 0}\n"
           "  c: {from: mean.measure, better: higher, matters: 0}\n"));
  EXPECT_TRUE(
      said("e.yaml:5:13: error[X007]: The metric 'a' is read from a stage 'meen', which the "
           "pipeline does not have. Did you mean 'mean'?"))
      << said_;
  EXPECT_TRUE(
      said("e.yaml:6:13: error[X008]: Stage 'change' (toy/scale) gives no measures. "
           "Measures come from 'mean'."))
      << said_;
  EXPECT_TRUE(
      said("e.yaml:7:13: error[X008]: Stage 'mean' (toy/mean) has no output 'measure' with "
           "measures. Did you mean 'mean.measures'?"))
      << said_;
}

TEST_F(ExperimentPlanTest, ARecordingThatAnArmLacksIsLeftOutOfIt) {
  write("there.txt", "1 2 3\n");
  const auto made =
      plan(std::string("arms: {one: , two: {draw.file: gone.txt}, three: }\n"
                       "recordings: {a: {draw.count: 2}, b: {draw.file: there.txt}}\n") +
           kMetric);
  EXPECT_FALSE(made) << "nothing is left for arm two";
  EXPECT_TRUE(said("error[X009]: The arm 'two' lacks every recording.")) << said_;
  const auto some =
      plan(std::string("arms: {one: , two: {change.factor: 2}}\n"
                       "recordings: {a: {draw.file: gone.txt}, b: {draw.count: 2}}\n") +
           kMetric);
  ASSERT_TRUE(some) << said_;
  EXPECT_FALSE(some->of(0, 0).plan);
  EXPECT_NE(some->of(0, 0).why_not.find("gone.txt"), std::string::npos) << some->of(0, 0).why_not;
  EXPECT_TRUE(some->of(0, 1).plan);
}

TEST_F(ExperimentPlanTest, ARecordingWhoseFolderTheEnvironmentDoesNotNameIsLeftOut) {
  const auto made = plan(
      std::string("arms: {one: , two: {change.factor: 2}}\n"
                  "recordings: {a: {draw.file: \"${NO_SUCH_DATA}/a.txt\"}, b: {draw.count: 2}}\n") +
      kMetric);
  ASSERT_TRUE(made) << said_;
  EXPECT_NE(made->of(0, 0).why_not.find("NO_SUCH_DATA"), std::string::npos);
}

TEST_F(ExperimentPlanTest, AnArmMayVaryAnotherPipeline) {
  write("other.yaml",
        "stope: 1\nstages:\n  draw: {use: toy/draw}\n"
        "  change: {use: toy/shift, in: draw}\n"
        "  more: {use: toy/shift, in: change}\n"
        "  mean: {use: toy/mean, in: more}\n");
  const auto made =
      plan(std::string("arms: {one: , two: {base: other.yaml, more.by: 3}}\n") + kMetric);
  ASSERT_TRUE(made) << said_;
  EXPECT_EQ(made->of(1, 0).plan->stages.size(), 4U);
}

TEST_F(ExperimentPlanTest, AStageThatAMetricReadsIsRead) {
  const auto made = plan(std::string("arms: {one: , two: {change.factor: 2}}\n") + kMetric);
  ASSERT_TRUE(made) << said_;
  EXPECT_TRUE(made->warnings.empty()) << made->warnings.front();
}

}  // namespace
}  // namespace stope
