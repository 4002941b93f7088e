#include "framework/pipeline/plan_json.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "checked.hpp"

namespace stope {
namespace {

TEST(PlanJson, SaysEverythingThatWasResolved) {
  const Checked checked = check_text(
      "stope: 1\nname: small\nvars: {extent: 0.3 km}\nstages:\n"
      "  pit: {use: source/synthetic_pit, params: {extent: \"${extent}\"}}\n"
      "outputs: {t.tum: pit.trajectory}\n");
  ASSERT_TRUE(checked.plan) << checked.text;
  const nlohmann::json json = plan_json(*checked.plan);
  EXPECT_EQ(json["name"], "small");
  EXPECT_EQ(json["vars"]["extent"], "0.3 km");
  EXPECT_EQ(json["stages"][0]["use"], "source/synthetic_pit");
  EXPECT_EQ(json["stages"][0]["at"], "pit.yaml:5:3");
  EXPECT_EQ(json["stages"][0]["parameters"]["extent"]["value"], 300.0);
  EXPECT_EQ(json["stages"][0]["parameters"]["extent"]["unit"], "m");
  EXPECT_EQ(json["stages"][0]["outputs"]["scans"]["stream"], true);
  EXPECT_EQ(json["stages"][1]["inputs"]["trajectory"], "pit.trajectory");
  EXPECT_EQ(json["outputs"][0]["name"], "t.tum");
  EXPECT_EQ(json["outputs"][0]["use"], "export/tum");
}

TEST(PlanJson, IsTheSameHoweverThePipelineIsWritten) {
  const Checked one = check_text(
      "stope: 1\nname: n\nstages:\n  pit: {use: source/synthetic_pit, params: {extent: 300}}\n");
  const Checked two = check_text(
      "name: n\nstope: 1\nstages:\n  pit: {params: {extent: 30000 cm}, use: "
      "source/synthetic_pit}\n");
  ASSERT_TRUE(one.plan && two.plan);
  EXPECT_EQ(plan_json(*one.plan).dump(), plan_json(*two.plan).dump());
}

TEST(PlanJson, InfinityIsAText) {
  EXPECT_EQ(value_json(ParameterValue{std::numeric_limits<double>::infinity()}), "inf");
  EXPECT_EQ(value_json(ParameterValue{}), nullptr);
}

}  // namespace
}  // namespace stope
