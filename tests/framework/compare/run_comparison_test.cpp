#include "framework/compare/run_comparison.hpp"

#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>
#include <thread>

#include "framework/compare/comparison_json.hpp"
#include "framework/compare/metric_check.hpp"
#include "framework/pipeline/check.hpp"
#include "framework/report/run_report.hpp"
#include "stope/error.hpp"
#include "tests/framework/compare/comparing.hpp"

namespace stope {
namespace {

using Ran = std::map<std::string, int>;
using RunComparison = testing::ComparingTest;

constexpr const char* kMean = "metrics: {mean: {from: mean, better: higher, matters: 100 mm}}\n";
constexpr const char* kTwoArms = "arms: {one: , two: {change.factor: 2}}\n";

TEST_F(RunComparison, WhatArmsHaveInCommonRunsOnce) {
  const Comparison made = compare(
      std::string("arms: {one: , two: {change.factor: 2}, shift: {change.use: toy/shift}}\n") +
      kMean);
  EXPECT_EQ(ran_, (Ran{{"draw", 1}, {"scale", 2}, {"shift", 1}, {"mean", 3}, {"text", 3}}));
  EXPECT_TRUE(made.complete);
  const ComparedCell& cell = made.cell(1, 0, 0);
  EXPECT_EQ(cell.status, CellStatus::kDone) << cell.sentence;
  EXPECT_EQ(cell.stages[0].fate, StageFate::kShared);
  EXPECT_EQ(cell.stages[1].fate, StageFate::kRan);
  EXPECT_GE(cell.stages[1].seconds, 0);
  EXPECT_DOUBLE_EQ(cell.measures[0], 2 * made.cell(0, 0, 0).measures[0]);
  EXPECT_EQ(made.metrics[0].unit, "m");
  EXPECT_DOUBLE_EQ(made.metrics[0].smallest_that_matters, 0.1);
  ASSERT_EQ(cell.artefacts.size(), 1U);
  EXPECT_EQ(cell.artefacts[0].path, "arms/two/base/0/outputs/changed.txt");
  EXPECT_TRUE(std::filesystem::exists(made.folder / "arms/two/base/0/run.json"));
}

// A replay sets what all arms, the recording and the arm change; the seed is the run's.
TEST_F(RunComparison, EachRunNamesAllThatWasSetForIt) {
  compare(std::string("arms: {one: {change.noise: 1}, two: {change.noise: 2}}\n"
                      "set: {draw.count: 4, change.noise: 7}\n"
                      "recordings: {pit: {seed: 3, draw.count: 6}}\n") +
          kMean);
  const auto run = nlohmann::json::parse(read(folder() / "out/arms/two/pit/3/run.json"));
  EXPECT_EQ(run["pipeline"]["overrides"],
            (std::vector<std::string>{"draw.count=6", "change.noise=2"}));
  EXPECT_EQ(run["run"]["seed"], 3);
}

TEST_F(RunComparison, AnArmLeavesTheBytesOfARunOfItAlone) {
  compare(std::string("arms: {one: {change.noise: 1}, two: {change.noise: 2}}\nseeds: [7]\n") +
          kMean);
  for (const std::string& arm : {std::string("one"), std::string("two")}) {
    Diagnostics diagnostics;
    const auto plan = check_pipeline(folder() / "pit.yaml",
                                     {std::string("change.noise=") + (arm == "one" ? "1" : "2")},
                                     catalogue_, diagnostics);
    ASSERT_TRUE(plan) << text_of(diagnostics);
    RunReport report(*plan, catalogue_, {}, folder() / ("alone_" + arm));
    RunOptions options;
    options.seed = 7;
    report.finish(run_plan(*plan, catalogue_, report.sinks(), options, log_));
    EXPECT_EQ(output(arm, "base", "7"), read(folder() / ("alone_" + arm) / "outputs/changed.txt"));
  }
  EXPECT_NE(output("one", "base", "7"), output("two", "base", "7"));
}

TEST_F(RunComparison, AFailingArmIsReportedAndTheOthersAreFinished) {
  const Comparison made =
      compare(std::string("arms: {one: , broken: {change.fails: true}, also: {change.fails: true, "
                          "change.factor: 3}, two: {change.factor: 2}}\n") +
              kMean);
  EXPECT_TRUE(made.complete);
  for (const std::size_t arm : {1U, 2U}) {
    const ComparedCell& broken = made.cell(arm, 0, 0);
    EXPECT_EQ(broken.status, CellStatus::kFailed);
    EXPECT_EQ(broken.failed_stage, "change");
    EXPECT_NE(broken.sentence.find("change (" + made.arms[arm].name + ")"), std::string::npos)
        << broken.sentence;
    EXPECT_NE(broken.sentence.find("the scales are broken"), std::string::npos);
  }
  EXPECT_EQ(made.exclusions.size(), 2U);
  EXPECT_EQ(made.cell(3, 0, 0).status, CellStatus::kDone);
  EXPECT_DOUBLE_EQ(made.cell(3, 0, 0).measures[0], 2 * made.cell(0, 0, 0).measures[0]);
  EXPECT_EQ(ran_, (Ran{{"draw", 1}, {"scale", 4}, {"mean", 2}, {"text", 2}}))
      << "what failed stopped nothing of the others, and nothing was begun anew";
}

TEST_F(RunComparison, WhatFailsFirstInTheOrderOfThePlanIsTold) {
  for (int time = 0; time < 5; ++time) {
    std::filesystem::remove_all(folder() / "out");
    const Comparison made =
        compare(std::string("arms: {one: , broken: {change.fails: true, mean.use: toy/count, "
                            "mean.fails: true, mean.in: draw}}\n"
                            "metrics: {count: {from: mean, better: higher, matters: 1}}\n"));
    EXPECT_EQ(made.cell(1, 0, 0).failed_stage, "change");
    EXPECT_EQ(made.exclusions.size(), 1U);
  }
}

TEST_F(RunComparison, IfASharedStageFailsAllItsArmsHaveFailed) {
  const Comparison made = compare(
      std::string("set: {change.fails: true}\narms: {one: , two: {change.factor: 2}}\n") + kMean);
  EXPECT_EQ(made.cell(0, 0, 0).status, CellStatus::kFailed);
  EXPECT_EQ(made.cell(1, 0, 0).status, CellStatus::kFailed);
}

TEST_F(RunComparison, GoneOnWithItComputesNothingTwice) {
  const std::string experiment = std::string(kTwoArms) + kMean;
  const Comparison first = compare(experiment);
  const std::string before = output("two");
  const Comparison again = compare(experiment);
  EXPECT_EQ(ran_, Ran{});
  EXPECT_EQ(again.id, first.id);
  EXPECT_DOUBLE_EQ(again.metrics[0].smallest_that_matters, 0.1);
  EXPECT_EQ(comparison_json(again).substr(comparison_json(again).find("\"baseline\"")),
            comparison_json(first).substr(comparison_json(first).find("\"baseline\"")));
  compare(std::string("arms: {one: , two: {change.factor: 2}, new: {change.factor: 3}}\n") + kMean);
  EXPECT_EQ(ran_, (Ran{{"scale", 1}, {"mean", 1}, {"text", 1}})) << "only the new arm";
  EXPECT_EQ(output("two"), before);
}

TEST_F(RunComparison, ACellWhoseInputWasSwappedMeanwhileIsComputedAgain) {
  write("numbers.txt", "1 2 3");
  // Times of files go on in steps.
  std::this_thread::sleep_for(std::chrono::milliseconds(30));
  const std::string experiment =
      std::string(kTwoArms) + "recordings: {mine: {draw.file: numbers.txt}}\n" + kMean;
  toy::before_drawing = [&] { write("numbers.txt", "7 7 7"); };
  toy::after_drawing = [&] { write("numbers.txt", "1 2 3"); };
  const Comparison swapped = compare(experiment);
  toy::before_drawing = toy::after_drawing = {};
  EXPECT_DOUBLE_EQ(swapped.cell(0, 0, 0).measures.at(0), 7);
  EXPECT_NE(log_.text.find("numbers.txt was changed, replaced or touched"), std::string::npos)
      << log_.text;
  const Comparison right = compare(experiment);
  EXPECT_EQ(ran_.at("draw"), 1);
  EXPECT_DOUBLE_EQ(right.cell(0, 0, 0).measures.at(0), 2);
  compare(experiment);
  EXPECT_EQ(ran_, Ran{});
}

TEST_F(RunComparison, AnOutputThatHasGoneComesBackFromTheStore) {
  const std::string experiment = std::string(kTwoArms) + kMean;
  compare(experiment);
  const std::string before = output("two");
  std::filesystem::remove(folder() / "out/arms/two/base/0/outputs/changed.txt");
  const Comparison again = compare(experiment);
  EXPECT_EQ(ran_, Ran{});
  EXPECT_EQ(output("two"), before);
  EXPECT_EQ(again.cell(1, 0, 0).stages[1].fate, StageFate::kNotNeeded);
}

TEST_F(RunComparison, CancelledItKeepsWhatIsDoneAndGoesOn) {
  const std::string experiment =
      std::string(kTwoArms) + "recordings: {cross: {draw.count: [2, 3, 4]}}\n" + kMean;
  std::atomic<bool> stop{true};
  const Comparison stopped = compare(experiment, &stop);
  EXPECT_FALSE(stopped.complete);
  EXPECT_EQ(stopped.cell(0, 2, 0).status, CellStatus::kPending);
  const Comparison rest = compare(experiment);
  EXPECT_TRUE(rest.complete);
  EXPECT_EQ(rest.cell(0, 2, 0).status, CellStatus::kDone);
}

TEST_F(RunComparison, AFigureThatIsNoNumberIsLeftOutWithTheReason) {
  const Comparison made = compare(
      "arms: {one: {change.use: toy/shift}, two: {change.use: toy/shift, change.spoils: true}}\n"
      "metrics: {mean: {from: mean, better: higher, matters: 0.1 m}}\n");
  EXPECT_TRUE(std::isnan(made.cell(1, 0, 0).measures[0]));
  EXPECT_TRUE(std::isfinite(made.cell(0, 0, 0).measures[0]));
  ASSERT_EQ(made.exclusions.size(), 1U);
  EXPECT_EQ(made.exclusions[0].arm, "two");
  EXPECT_EQ(made.exclusions[0].metric, "mean");
  EXPECT_EQ(made.exclusions[0].sentence,
            "The figure 'mean' of stage 'mean' is nan, which cannot be compared.");
}

TEST_F(RunComparison, AFigureThatNoRunGivesStopsItAtTheFirstThatMeasures) {
  const std::string recordings = "recordings: {cross: {draw.count: [2, 3, 4]}}\n";
  try {
    compare(kTwoArms + recordings +
            "metrics:\n"
            "  mean: {from: mean, better: higher, matters: 0.1 m}\n"
            "  number: {from: mean, measure: cuont, better: higher, matters: 1}\n"
            "  length: {from: mean, measure: mean, better: higher, matters: 1 s}\n");
    FAIL() << "it was not stopped";
  } catch (const WrongExperiment& error) {
    ASSERT_EQ(error.diagnostics().size(), 2U) << error.what();
    EXPECT_EQ(to_text(error.diagnostics()[0]).substr(folder().string().size()),
              "/e.yaml:7:33: error[X010]: Stage 'mean' gave no figure 'cuont'. Did you mean "
              "'count'?");
    EXPECT_EQ(to_text(error.diagnostics()[1]).substr(folder().string().size()),
              "/e.yaml:8:64: error[X011]: The figure 'mean' is in m, but the experiment says what "
              "matters of it in s. Write it in m.");
  }
  EXPECT_EQ(toy::executions.take()["draw"], 1) << "the other recordings were not begun";
  // What was computed is not lost on whoever corrects it.
  compare(kTwoArms + recordings +
          "metrics: {number: {from: mean, measure: count, better: higher, "
          "matters: 1}}\n");
  EXPECT_EQ(ran_["draw"], 2);
  EXPECT_LE(ran_["scale"], 5) << "an arm's stage may have been stopped";
}

TEST_F(RunComparison, AFigureThatOnlySomeArmsGiveIsLeftOutOfTheOthers) {
  // `count` gives no mean, whichever of the two arms comes first.
  for (const std::string arms : {"arms: {one: , two: {mean.use: toy/count}}\n",
                                 "arms: {two: {mean.use: toy/count}, one: }\n"}) {
    std::filesystem::remove_all(folder() / "out");
    const Comparison made = compare(arms + kMean);
    ASSERT_EQ(made.exclusions.size(), 1U);
    EXPECT_EQ(made.exclusions[0].arm, "two");
    EXPECT_EQ(made.exclusions[0].sentence, "Stage 'mean' gave no figure 'mean'. It gave 'count'.");
  }
}

TEST_F(RunComparison, EqualArmsAreSaidToBeEqualAndRunOnce) {
  const Comparison made = compare(
      std::string("arms: {one: , same: {change.factor: 1}, two: {change.factor: 2}}\n") + kMean);
  EXPECT_EQ(made.arms[1].same_as, "one");
  EXPECT_EQ(made.arms[2].same_as, "");
  ASSERT_EQ(made.warnings.size(), 1U);
  EXPECT_EQ(made.warnings[0],
            "the arms 'one' and 'same' do the very same: nothing that makes their results differs");
  EXPECT_EQ(ran_["scale"], 2);
  EXPECT_EQ(output("same"), output("one"));
  EXPECT_TRUE(outputs_identical(made, 0, 1));
  EXPECT_FALSE(outputs_identical(made, 0, 2));
}

TEST_F(RunComparison, ARecordingThatAnArmLacksIsExcluded) {
  const Comparison made =
      compare(std::string(kTwoArms) +
              "recordings: {gone: {draw.file: gone.txt}, b: {draw.count: 2}}\n" + kMean);
  EXPECT_TRUE(made.complete);
  EXPECT_EQ(made.cell(0, 0, 0).status, CellStatus::kExcluded);
  EXPECT_EQ(made.cell(0, 1, 0).status, CellStatus::kDone);
  EXPECT_EQ(made.exclusions.size(), 2U);
}

TEST_F(RunComparison, AStoreThatCannotBeUsedIsWarnedOfOnceAndCostsNoResult) {
  write("file", "");
  store_ = "file/store";
  const Comparison made = compare(std::string(kTwoArms) +
                                  "recordings: {a: {draw.count: 2}, b: {draw.count: 3}}\n" + kMean);
  ASSERT_EQ(made.warnings.size(), 1U);
  EXPECT_TRUE(made.warnings[0].starts_with(
      "not all could be taken from the store or kept in it: cannot make the store"))
      << made.warnings[0];
  EXPECT_TRUE(made.exclusions.empty());
  EXPECT_EQ(measured_pairs(made, 1)[0].pairs.size(), 2U);
}

TEST_F(RunComparison, ASeedThatARecordingSetsIsTheOneThatIsTold) {
  const Comparison made =
      compare("arms: {one: , broken: {change.fails: true}}\nrecordings: {cross: {seed: [3, 4]}}\n" +
              std::string(kMean));
  EXPECT_EQ(made.cell(0, 1, 0).run_seed, 4U);
  ASSERT_EQ(made.exclusions.size(), 2U);
  EXPECT_EQ(made.exclusions[1].seed, 4U);
  EXPECT_EQ(made.cell(1, 1, 0).folder, "arms/broken/seed=4/4");
}

TEST_F(RunComparison, FoldersOfOthersAreLeftAlone) {
  std::filesystem::create_directories(folder() / "out");
  write("out/run.json", "{}");
  write("out/report.html", "mine");
  const std::string experiment = std::string(kTwoArms) + kMean;
  try {
    compare(experiment);
    FAIL() << "it was written into";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("is neither empty nor the folder of a comparison"),
              std::string::npos)
        << error.what();
  }
  EXPECT_EQ(read(folder() / "out/report.html"), "mine");
  EXPECT_FALSE(std::filesystem::exists(folder() / "out/arms"));
  std::filesystem::remove_all(folder() / "out");
  std::filesystem::create_directories(folder() / "out/.scratch.stope-part");
  EXPECT_TRUE(compare(experiment).complete) << "what a killed comparison left is no hindrance";
}

TEST_F(RunComparison, SaysBeforeItRunsThatRecordingsAreTooFew) {
  compare(std::string(kTwoArms) + kMean);
  EXPECT_EQ(log_.text.rfind("One recording cannot show any difference beside one test", 0), 0U)
      << log_.text;
  log_.text.clear();
  compare(std::string(kTwoArms) + kMean);
  EXPECT_EQ(log_.text.find("cannot show"), std::string::npos) << "nothing is left to spend";
}

TEST_F(RunComparison, SeedsAndRecordingsMakeRunsOfTheirOwn) {
  const Comparison made = compare(std::string(kTwoArms) +
                                  "recordings: {a: {draw.count: 2}, b: {draw.count: 3}}\n"
                                  "seeds: [1, 2]\n" +
                                  kMean);
  EXPECT_EQ(ran_["draw"], 4);
  EXPECT_EQ(ran_["scale"], 8);
  EXPECT_NE(output("one", "a", "1"), output("one", "a", "2"));
  EXPECT_EQ(measured_pairs(made, 1)[0].pairs.size(), 2U);
}

TEST_F(RunComparison, TimingsAreOfTheStagesThatDiffer) {
  const Comparison made = compare(std::string(kTwoArms) + kMean + "timing: {pairs: 3}\n");
  ASSERT_EQ(made.timings.size(), 1U);
  EXPECT_EQ(made.timings[0].arm_seconds.size(), 3U);
  EXPECT_EQ(made.timings[0].baseline_seconds.size(), 3U);
  EXPECT_EQ(ran_, (Ran{{"draw", 1}, {"scale", 2 + 2 * 4}, {"mean", 2}, {"text", 2}}))
      << "one of each to begin with, three pairs";
}

TEST_F(RunComparison, TimingsAreKeptUntilSomebodyAsksForThemAnew) {
  const std::string two = "arms: {one: , two: {change.factor: 2}}\ntiming: {pairs: 3}\n";
  const std::vector<TimedPair> first = compare(two + kMean).timings;
  const std::vector<TimedPair> again = compare(two + kMean).timings;
  EXPECT_EQ(ran_, Ran{});
  ASSERT_EQ(again.size(), 1U);
  EXPECT_EQ(again[0].arm_seconds, first[0].arm_seconds);
  EXPECT_EQ(again[0].baseline_seconds, first[0].baseline_seconds);
  // Another arm before it, of which nothing is known.
  const std::vector<TimedPair> more =
      compare(
          "arms: {one: , more: {change.factor: 3}, two: {change.factor: 2}}\ntiming: {pairs: "
          "3}\n" +
          std::string(kMean))
          .timings;
  EXPECT_EQ(ran_, (Ran{{"scale", 1 + 2 * 4}, {"mean", 1}, {"text", 1}}));
  ASSERT_EQ(more.size(), 2U);
  EXPECT_EQ(more[1].arm, 2U);
  EXPECT_EQ(more[1].arm_seconds, first[0].arm_seconds);
  time_again_ = true;
  EXPECT_EQ(compare(two + kMean).timings[0].arm_seconds.size(), 3U);
  EXPECT_EQ(ran_, (Ran{{"scale", 2 * 4}}));
}

TEST_F(RunComparison, AFolderOfAnotherComparisonIsLeftAlone) {
  compare("name: mine\n" + std::string(kTwoArms) + kMean);
  const std::string before = read(folder() / "out/comparison.json");
  EXPECT_THROW(compare("name: other\n" + std::string(kTwoArms) + kMean), Error);
  EXPECT_EQ(read(folder() / "out/comparison.json"), before);
  write("out/comparison.json", "what is this");
  EXPECT_THROW(compare("name: mine\n" + std::string(kTwoArms) + kMean), Error);
  EXPECT_EQ(read(folder() / "out/comparison.json"), "what is this");
}

}  // namespace
}  // namespace stope
