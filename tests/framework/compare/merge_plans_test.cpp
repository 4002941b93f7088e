#include "framework/compare/merge_plans.hpp"

#include "framework/compare/arm_record.hpp"
#include "framework/compare/experiment/experiment_plan.hpp"
#include "tests/framework/compare/files_of_test.hpp"
#include "tests/framework/compare/toy_arms.hpp"

namespace stope {
namespace {

class MergePlansTest : public testing::FilesTest {
 protected:
  void plan(const std::string& arms) {
    write("pit.yaml", toy::kPipeline);
    Diagnostics diagnostics;
    const auto experiment = read_experiment(
        write("e.yaml", "stope_experiment: 1\nbase: pit.yaml\narms: " + arms +
                            "\nmetrics: {mean: {from: mean, better: higher, matters: 0}}\n"),
        diagnostics);
    ASSERT_TRUE(experiment) << text_of(diagnostics);
    planned_ = plan_experiment(*experiment, catalogue_, diagnostics);
    ASSERT_TRUE(planned_) << text_of(diagnostics);
    for (const PlannedArm& arm : planned_->all)
      keys_.push_back(stage_keys(*arm.plan, catalogue_, {}));
    for (std::size_t i = 0; i < planned_->arms; ++i)
      arms_.push_back({experiment->arms[i].name, &*planned_->all[i].plan, &keys_[i]});
  }
  static std::vector<std::string> names(const Plan& plan) {
    std::vector<std::string> list;
    for (const PlannedStage& stage : plan.stages) list.push_back(stage.name);
    return list;
  }

  toy::ArmsCatalogue catalogue_;
  std::optional<ExperimentPlan> planned_;
  std::vector<std::vector<StageKey>> keys_;
  std::vector<PlanToMerge> arms_;
};

using Names = std::vector<std::string>;
using Owners = std::vector<std::size_t>;

TEST_F(MergePlansTest, WhatIsEqualStandsOnceAndTheRestIsCalledByItsArms) {
  plan("{one: , two: {change.factor: 2}, same: {change.factor: 2}}");
  const MergedPlan merged = merge_plans(arms_);
  EXPECT_EQ(names(merged.plan),
            (Names{"draw", "change (one)", "mean (one)", "outputs/changed.txt (one)",
                   "change (two, same)", "mean (two, same)", "outputs/changed.txt (two, same)"}));
  EXPECT_EQ(merged.owners[0], (Owners{0, 1, 2}));
  EXPECT_EQ(merged.owners[4], (Owners{1, 2}));
  EXPECT_EQ(merged.places[1], merged.places[2]);
}

TEST_F(MergePlansTest, KeysStayWhatTheyAreInTheArmsOwnPlans) {
  plan("{one: {change.noise: 1}, two: {change.noise: 2}, three: {draw.count: 2}}");
  const MergedPlan merged = merge_plans(arms_);
  const std::vector<StageKey> keys = stage_keys(merged.plan, catalogue_, {});
  for (std::size_t arm = 0; arm < arms_.size(); ++arm)
    for (std::size_t i = 0; i < keys_[arm].size(); ++i)
      EXPECT_EQ(keys[merged.places[arm][i]].digest, keys_[arm][i].digest)
          << merged.plan.stages[merged.places[arm][i]].name;
}

TEST_F(MergePlansTest, InputsComeFromEarlierStages) {
  plan("{one: , two: {change.use: toy/shift}, three: {draw.count: 2}}");
  const MergedPlan merged = merge_plans(arms_);
  for (std::size_t i = 0; i < merged.plan.stages.size(); ++i)
    for (const auto& input : merged.plan.stages[i].inputs) EXPECT_TRUE(!input || input->stage < i);
}

TEST_F(MergePlansTest, WithoutAnArmTheOthersKeepTheirStagesAndNames) {
  plan("{one: , two: {change.factor: 2}, three: {change.factor: 3}}");
  const MergedPlan rest = without_arms(merge_plans(arms_), {0, 2});
  EXPECT_EQ(names(rest.plan),
            (Names{"draw", "change (two)", "mean (two)", "outputs/changed.txt (two)"}));
  EXPECT_EQ(rest.plan.stages[1].inputs[0], (PlannedSource{0, 0}));
  EXPECT_EQ(rest.source(1, planned_->all[1].metrics[0]), (PlannedSource{2, 0}));
}

TEST(BusySeconds, OfAMapAreItsItemsAndNotItsWaitForWorkers) {
  ProcessRecord map;
  map.run = 5'000'000'000;  // its thread watched for so long
  map.work = 3'000'000'000;
  map.io = 250'000'000;
  map.wait_in = 9'000'000'000;
  EXPECT_DOUBLE_EQ(busy_seconds(map), 3.25);
  ProcessRecord stage = map;
  stage.work = 0;
  EXPECT_DOUBLE_EQ(busy_seconds(stage), 5.25);
}

}  // namespace
}  // namespace stope
