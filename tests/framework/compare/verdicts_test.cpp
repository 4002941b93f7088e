#include "framework/compare/verdicts.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "framework/compare/remarks.hpp"

namespace stope {
namespace {

/// Arms that differ from the first by `differences`, on as many pits, by one metric; all done.
Comparison made(const std::vector<double>& differences, std::size_t pits) {
  Comparison comparison;
  comparison.seeds = {0};
  comparison.metrics = {{"apls", "score", "apls", Direction::kHigher, 0.01, ""}};
  for (std::size_t pit = 0; pit < pits; ++pit)
    comparison.recordings.push_back({"pit-" + std::to_string(pit), {}, {}});
  for (std::size_t arm = 0; arm < differences.size(); ++arm)
    comparison.arms.push_back({"arm-" + std::to_string(arm), {}, {}, {}});
  for (std::size_t pit = 0; pit < pits; ++pit)
    for (std::size_t arm = 0; arm < differences.size(); ++arm) {
      ComparedCell cell;
      cell.arm = arm;
      cell.recording = pit;
      cell.status = CellStatus::kDone;
      cell.measures = {differences[arm] * (1 + 0.05 * static_cast<double>(pit))};
      cell.artefacts = {{"roads.geojson", "", std::to_string(arm) + " on " + std::to_string(pit), 9,
                         CellArtefact::Kind::kGeojson, false}};
      comparison.cells.push_back(cell);
    }
  return comparison;
}

TEST(Verdicts, AreOfEachArmButTheBaseline) {
  const auto verdicts = verdicts_of(made({0, 1, -1}, 8));
  ASSERT_EQ(verdicts.size(), 2U);
  EXPECT_EQ(verdicts[0].arm, 1U);
  EXPECT_EQ(verdicts[0].measures[0].verdict, Verdict::kBetter);
  EXPECT_EQ(verdicts[1].measures[0].verdict, Verdict::kWorse);
}

TEST(Verdicts, AreAdjustedForAllArmsTogether) {
  // Six recordings that agree have a chance of 2 / 64: enough alone, not beside another arm's.
  EXPECT_EQ(verdicts_of(made({0, 1}, 6))[0].measures[0].verdict, Verdict::kBetter);
  const ComparedMeasure beside = verdicts_of(made({0, 1, 0.5}, 6))[0].measures[0];
  EXPECT_EQ(beside.verdict, Verdict::kNoDifferenceShown);
  EXPECT_DOUBLE_EQ(beside.adjusted, 4.0 / 64);
  EXPECT_EQ(beside.tests, 2U);
}

// As if what one arm changes made no difference on these pits.
void make_twins(Comparison& comparison, std::size_t arm, std::size_t other) {
  for (std::size_t pit = 0; pit < comparison.recordings.size(); ++pit) {
    comparison.cell(arm, pit, 0).measures = comparison.cell(other, pit, 0).measures;
    comparison.cell(arm, pit, 0).artefacts = comparison.cell(other, pit, 0).artefacts;
  }
}

TEST(Verdicts, OfACopyAreThoseOfWhatItCopies) {
  Comparison comparison = made({0, 1, 1, 0}, 6);
  comparison.arms[2].same_as = "arm-1";
  comparison.arms[3].same_as = "arm-0";
  make_twins(comparison, 2, 1);
  make_twins(comparison, 3, 0);
  const auto verdicts = verdicts_of(comparison);
  for (const std::size_t arm : {0U, 1U}) {
    EXPECT_EQ(verdicts[arm].measures[0].verdict, Verdict::kBetter);
    EXPECT_EQ(verdicts[arm].measures[0].tests, 1U) << "a copy is no second chance";
  }
  EXPECT_EQ(verdicts[2].measures[0].verdict, Verdict::kIdentical);
}

TEST(Verdicts, OfATwinByItsOutputsAreNoSecondChance) {
  Comparison comparison = made({0, 1, 0}, 6);
  make_twins(comparison, 2, 1);
  const auto verdicts = verdicts_of(comparison);
  EXPECT_FALSE(verdicts[0].twin);
  ASSERT_TRUE(verdicts[1].twin);
  EXPECT_EQ(*verdicts[1].twin, 1U);
  for (const ArmVerdicts& arm : verdicts) {
    EXPECT_EQ(arm.measures[0].tests, 1U);
    EXPECT_EQ(arm.measures[0].verdict, Verdict::kBetter);
  }
  EXPECT_EQ(remarks_of(comparison, verdicts[1]),
            (std::vector<std::string>{"arm-2 and arm-1 left the very same files and figures in "
                                      "every run: they are counted once."}));
}

TEST(Verdicts, OfArmsWithEqualFiguresButOtherFilesAreBothCounted) {
  Comparison comparison = made({0, 1, 0}, 6);
  make_twins(comparison, 2, 1);
  comparison.cell(2, 3, 0).artefacts[0].sha256 = "another road";
  EXPECT_EQ(verdicts_of(comparison)[1].measures[0].tests, 2U);
  make_twins(comparison, 2, 1);
  comparison.cell(2, 3, 0).status = CellStatus::kFailed;
  EXPECT_FALSE(verdicts_of(comparison)[1].twin) << "one of them failed where the other did not";
}

TEST(Verdicts, SevenNamesOfOneRecordingAreOneRecording) {
  Comparison comparison = made({0, 1}, 7);
  EXPECT_EQ(verdicts_of(comparison)[0].measures[0].verdict, Verdict::kBetter);
  for (std::size_t pit = 1; pit < 7; ++pit) comparison.recordings[pit].same_as = "pit-0";
  const ComparedMeasure measure = verdicts_of(comparison)[0].measures[0];
  EXPECT_EQ(measure.verdict, Verdict::kTooFew);
  EXPECT_EQ(measure.recordings, (std::vector<std::string>{"pit-0"}));
  EXPECT_TRUE(measure.excluded.empty());
  EXPECT_DOUBLE_EQ(measure.mean_difference, 1.15) << "the mean over its names";
}

TEST(Verdicts, SayWhenAllDifferencesAreEqualToTheLastBit) {
  Comparison comparison = made({0, 1}, 7);
  EXPECT_TRUE(remarks_of(comparison, verdicts_of(comparison)[0]).empty());
  for (std::size_t pit = 0; pit < 7; ++pit) comparison.cell(1, pit, 0).measures = {0.479};
  const auto remarks = remarks_of(comparison, verdicts_of(comparison)[0]);
  ASSERT_EQ(remarks.size(), 1U);
  EXPECT_EQ(remarks[0].rfind("All 7 differences in 'apls' are equal to the last bit", 0), 0U);
}

TEST(Verdicts, TellWhereAnArmFailedAndWhereThereIsNoFigureAtAll) {
  Comparison comparison = made({0, 1}, 10);
  EXPECT_EQ(losses_text(comparison, 1), "");
  for (const std::size_t pit : {2U, 5U, 6U, 7U})
    comparison.cell(1, pit, 0).status = CellStatus::kFailed;
  comparison.cell(0, 5, 0).status = CellStatus::kExcluded;
  EXPECT_EQ(losses_text(comparison, 1), "arm-1 failed on 4, arm-0 lacks 1");
  for (std::size_t pit = 0; pit < 10; ++pit) comparison.cell(1, pit, 0).measures = {std::nan("")};
  const ComparedMeasure measure = verdicts_of(comparison)[0].measures[0];
  EXPECT_EQ(measure.verdict, Verdict::kNoFigure);
  EXPECT_EQ(text_of(measure), "no usable figure on any recording");
}

TEST(Remarks, TellBeforeAnythingRunsThatRecordingsAreTooFew) {
  EXPECT_EQ(expected_remark(7, 4, 5),
            "7 recordings cannot show any difference beside 15 tests, however clear: it takes 10. "
            "There are 3 arms beside the baseline and 5 metrics.");
  EXPECT_EQ(expected_remark(10, 4, 5), "");
  EXPECT_EQ(expected_remark(1, 2, 1),
            "One recording cannot show any difference beside one test, however clear: it takes 6. "
            "There is one arm beside the baseline and one metric.");
  Comparison comparison = made({0, 1, 2, 3}, 7);
  comparison.metrics.resize(5);
  EXPECT_EQ(expected_remark(comparison), expected_remark(7, 4, 5));
  comparison.arms[3].same_as = "arm-1";
  comparison.recordings[6].same_as = "pit-0";
  EXPECT_EQ(expected_remark(comparison), expected_remark(6, 3, 5));
}

TEST(Verdicts, NameTheRecordingsThatDoNotCount) {
  Comparison comparison = made({0, 1}, 8);
  comparison.cell(1, 2, 0).status = CellStatus::kFailed;
  comparison.cell(0, 5, 0).status = CellStatus::kExcluded;
  const ComparedMeasure measure = verdicts_of(comparison)[0].measures[0];
  EXPECT_EQ(measure.excluded, (std::vector<std::string>{"pit-2", "pit-5"}));
  EXPECT_EQ(measure.recordings.size(), 6U);
  EXPECT_EQ(measure.differences.size(), 6U);
}

TEST(Verdicts, AreTooFewOfAComparisonThatHasNotBegun) {
  Comparison comparison = made({0, 1}, 8);
  for (ComparedCell& cell : comparison.cells) cell.status = CellStatus::kPending;
  const ComparedMeasure measure = verdicts_of(comparison)[0].measures[0];
  EXPECT_EQ(measure.verdict, Verdict::kTooFew);
  EXPECT_EQ(measure.excluded.size(), 8U);
}

}  // namespace
}  // namespace stope
