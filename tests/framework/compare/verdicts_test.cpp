#include "framework/compare/verdicts.hpp"

#include <gtest/gtest.h>

namespace stope {
namespace {

/// Arms that differ from the first by `differences`, on as many pits, by one metric; all done.
Comparison made(const std::vector<double>& differences, std::size_t pits) {
  Comparison comparison;
  comparison.seeds = {0};
  comparison.metrics = {{"apls", "score", "apls", Direction::kHigher, 0.01, ""}};
  for (std::size_t pit = 0; pit < pits; ++pit)
    comparison.recordings.push_back({"pit-" + std::to_string(pit), {}});
  for (std::size_t arm = 0; arm < differences.size(); ++arm)
    comparison.arms.push_back({"arm-" + std::to_string(arm), {}, {}, {}});
  for (std::size_t pit = 0; pit < pits; ++pit)
    for (std::size_t arm = 0; arm < differences.size(); ++arm) {
      ComparedCell cell;
      cell.arm = arm;
      cell.recording = pit;
      cell.status = CellStatus::kDone;
      cell.measures = {differences[arm] * (1 + 0.05 * static_cast<double>(pit))};
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

TEST(Verdicts, OfACopyAreThoseOfWhatItCopies) {
  Comparison comparison = made({0, 1, 1, 0}, 6);
  comparison.arms[2].same_as = "arm-1";
  comparison.arms[3].same_as = "arm-0";
  const auto verdicts = verdicts_of(comparison);
  for (const std::size_t arm : {0U, 1U}) {
    EXPECT_EQ(verdicts[arm].measures[0].verdict, Verdict::kBetter);
    EXPECT_EQ(verdicts[arm].measures[0].tests, 1U) << "a copy is no second chance";
  }
  EXPECT_EQ(verdicts[2].measures[0].verdict, Verdict::kIdentical);
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
