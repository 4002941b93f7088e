#include "framework/compare/report/downloads.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "made_comparison.hpp"

namespace stope::report {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

TEST(Downloads, VerdictsAreALineAnArmAndMetric) {
  const Comparison comparison = made::comparison_in("", {3, 8, 1, 0.3, "n", false});
  const auto lines = lines_of(verdicts_csv(comparison, verdicts_of(comparison)));
  ASSERT_EQ(lines.size(), 1U + 2 * 3);
  EXPECT_EQ(lines[1].rfind("voronoi,watershed,apls,,higher,0.02,better,matters,0.", 0), 0U)
      << lines[1];
  EXPECT_EQ(lines[3].rfind("voronoi,watershed,coverage,,higher,0.05,same,,", 0), 0U) << lines[3];
}

TEST(Downloads, MeasuresAreALineACellAndMetricEmptyWhereThereIsNone) {
  Comparison comparison = made::comparison_in("", {2, 2, 1, 0.3, "n", false});
  comparison.cells[1].measures[0] = std::nan("");
  comparison.cells[2].measures.clear();
  comparison.cells[2].status = CellStatus::kFailed;
  const auto lines = lines_of(measures_csv(comparison));
  ASSERT_EQ(lines.size(), 1U + 4 * 3);
  EXPECT_EQ(lines[4], "pit-0,0,voronoi,done,apls,,\r");
  EXPECT_EQ(lines[7], "pit-1,0,watershed,failed,apls,,\r");
}

TEST(Downloads, NameTheSeedThatTheRunHad) {
  Comparison comparison = made::comparison_in("", {2, 1, 1, 0.3, "n", false});
  for (ComparedCell& cell : comparison.cells) cell.run_seed = 7;
  comparison.timings = {{1, 0, 0, {1.5}, {0.5}, {}}};
  EXPECT_EQ(lines_of(measures_csv(comparison))[1].rfind("pit-0,7,watershed,done,", 0), 0U);
  EXPECT_EQ(lines_of(timings_csv(comparison))[1], "pit-0,7,voronoi,0,1.5,0.5\r");
  const auto json = nlohmann::json::parse(verdicts_json(comparison, verdicts_of(comparison)));
  EXPECT_EQ(json["runs"][0]["seed"], 7);
}

TEST(Downloads, GiveNoIntervalOfFewerThanSix) {
  const Comparison comparison = made::comparison_in("", {2, 5, 1, 0.3, "n", false});
  const auto verdicts = verdicts_of(comparison);
  const auto json = nlohmann::json::parse(verdicts_json(comparison, verdicts));
  EXPECT_TRUE(json["verdicts"][0]["metrics"][0]["interval"].is_null());
  EXPECT_TRUE(json["verdicts"][0]["metrics"][0]["difference"].is_number());
  const std::string line = lines_of(verdicts_csv(comparison, verdicts))[1];
  EXPECT_NE(line.find(",too_few,,"), std::string::npos);
  EXPECT_NE(line.find(",,,0."), std::string::npos) << "low and high are empty: " << line;
}

TEST(Downloads, WhatWouldBreakALineIsQuoted) {
  Comparison comparison = made::comparison_in("", {2, 1, 1, 0.3, "n", false});
  comparison.metrics[0].unit = "a,\"b\"";
  EXPECT_EQ(lines_of(measures_csv(comparison))[1].rfind(
                "pit-0,0,watershed,done,apls,\"a,\"\"b\"\"\",0.", 0),
            0U);
}

TEST(Downloads, StageTimesSayWhatBecameOfEach) {
  const Comparison comparison = made::comparison_in("", {2, 1, 1, 0.3, "n", false});
  const auto lines = lines_of(stage_times_csv(comparison));
  EXPECT_EQ(lines[1], "pit-0,0,watershed,done,scans,source/synthetic_pit,shared,1.2,110\r");
}

TEST(Downloads, TimingsAreALineAPairAndOnlyWhereSomeWereTaken) {
  Comparison comparison = made::comparison_in("", {2, 1, 1, 0.3, "n", false});
  EXPECT_EQ(downloads_of(comparison, verdicts_of(comparison)).size(), 4U);
  comparison.timings = {{1, 0, 0, {1.5, 2}, {0.5, 1}, {}}};
  EXPECT_EQ(timings_csv(comparison),
            "recording,seed,arm,pair,baseline_seconds,arm_seconds\r\n"
            "pit-0,0,voronoi,0,1.5,0.5\r\npit-0,0,voronoi,1,2,1\r\n");
  EXPECT_EQ(downloads_of(comparison, verdicts_of(comparison)).size(), 5U);
}

TEST(Downloads, JsonHoldsTheVerdictsAndTheDifferences) {
  Comparison comparison = made::comparison_in("", {2, 8, 1, 0.3, "n", false});
  comparison.exclusions = {{"voronoi", "pit-3", 0, "", "a stage failed \xff"}};
  const auto json = nlohmann::json::parse(verdicts_json(comparison, verdicts_of(comparison)));
  const auto& apls = json["verdicts"][0]["metrics"][0];
  EXPECT_EQ(apls["verdict"], "better");
  EXPECT_EQ(apls["matters"], true);
  EXPECT_EQ(apls["differences"].size(), 8U);
  EXPECT_NEAR(apls["differences"]["pit-2"],
              comparison.cell(1, 2, 0).measures[0] - comparison.cell(0, 2, 0).measures[0], 1e-12);
  EXPECT_EQ(json["exclusions"].size(), 1U);
  EXPECT_EQ(json["runs"].size(), 16U);
  EXPECT_EQ(json["runs"][3]["measures"]["apls"], comparison.cells[3].measures[0]);
}

}  // namespace
}  // namespace stope::report
