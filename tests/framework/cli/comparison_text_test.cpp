#include "framework/cli/comparison_text.hpp"

#include <gtest/gtest.h>

namespace stope {
namespace {

/// Arms that differ by `difference` on as many pits; all done.
Comparison made(std::size_t arms, std::size_t pits, double difference) {
  Comparison comparison;
  comparison.name = "toy";
  comparison.seeds = {0};
  comparison.metrics = {{"apls", "score", "apls", Direction::kHigher, 0.01, ""}};
  for (std::size_t pit = 0; pit < pits; ++pit)
    comparison.recordings.push_back({"pit-" + std::to_string(pit), {}, {}});
  for (std::size_t arm = 0; arm < arms; ++arm)
    comparison.arms.push_back({"arm-" + std::to_string(arm), {}, {}, {}});
  comparison.cells = empty_cells(comparison);
  for (ComparedCell& cell : comparison.cells) {
    cell.status = CellStatus::kDone;
    cell.measures = {static_cast<double>(cell.arm) *
                     (difference + 0.001 * static_cast<double>(cell.recording))};
  }
  return comparison;
}

void expect_line(const Comparison& comparison, const std::string& line) {
  const std::string text = comparison_text(comparison);
  EXPECT_NE(text.find(line + "\n"), std::string::npos) << line << "\nis not in\n" << text;
}

TEST(ComparisonText, SaysThatRecordingsCannotShowAnything) {
  expect_line(made(4, 6, 0.5),
              "Note: 6 recordings cannot show any difference beside 3 tests, however clear: it "
              "takes 7.");
}

TEST(ComparisonText, SaysWhereTheWinnerFailed) {
  Comparison comparison = made(2, 10, 0.5);
  for (std::size_t pit = 0; pit < 4; ++pit) comparison.cell(1, pit, 0).status = CellStatus::kFailed;
  expect_line(comparison, "arm-1 beside arm-0 (arm-1 failed on 4):");
  EXPECT_NE(comparison_text(comparison).find("over 6 of 10: better, and it matters"),
            std::string::npos);
}

TEST(ComparisonText, GivesNoIntervalOfFewerThanSixAndSaysWhy) {
  expect_line(made(2, 1, 0.5), "  apls  +0.5 [–] over 1: too few recordings to say");
  expect_line(made(2, 1, 0.5), "Note: [–]: below 6 recordings an interval cannot be believed.");
  EXPECT_EQ(comparison_text(made(2, 6, 0.5)).find("[–]"), std::string::npos);
}

TEST(ComparisonText, SaysWhatWarnsOfRecordingsThatAreOne) {
  Comparison comparison = made(2, 7, 0.5);
  comparison.warnings = {"the recordings 'a' and 'b' are one and the same"};
  expect_line(comparison, "Note: the recordings 'a' and 'b' are one and the same");
}

// The medians of an arm on three recordings are 2, 4 and 3 times the baseline's.
TEST(ComparisonText, SumsUpTheTimesOfAnArm) {
  Comparison comparison = made(2, 6, 0.5);
  for (const double times : {2.0, 4.0, 3.0})
    comparison.timings.push_back({1, 0, 0, {1, 0.5, 2}, {times, 0.5 * times, 2 * times}, "key"});
  EXPECT_NE(comparison_text(comparison).find("ratio pair by pair 3 [2, 4] over 3 recordings\n"),
            std::string::npos)
      << comparison_text(comparison);
  comparison.timings = {{1, 0, 0, {1, 1}, {2, 5}, "key"}};
  EXPECT_NE(comparison_text(comparison).find("ratio pair by pair 3.5 [2, 5] over one recording"),
            std::string::npos)
      << comparison_text(comparison);
}

}  // namespace
}  // namespace stope
