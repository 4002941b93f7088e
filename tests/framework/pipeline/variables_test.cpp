#include "framework/pipeline/variables.hpp"

#include <gtest/gtest.h>

#include <cstdlib>

#include "checked.hpp"

namespace stope {
namespace {

// A pipeline with these variables in which `value` is a parameter.
std::string pipeline(const std::string& vars, const std::string& stage, const std::string& value) {
  return "stope: 1\nvars: " + vars +
         "\nstages:\n  pit: {use: source/synthetic_pit}\n  it: {use: " + stage +
         ", in: {scans: pit, trajectory: pit}, params: {" + value + "}}\n";
}

TEST(Variables, AWholeScalarTakesTheNodeWithItsType) {
  const Checked checked = check_text(pipeline("{all: [ground, wall], w: [1, 50 %]}", "map/voxels",
                                              "labels: \"${all}\", weights: \"${w}\""));
  ASSERT_TRUE(checked.plan) << checked.text;
  EXPECT_EQ(std::get<std::vector<std::string>>(checked.parameter("it", "labels")),
            (std::vector<std::string>{"ground", "wall"}));
  EXPECT_EQ(std::get<std::vector<double>>(checked.parameter("it", "weights")),
            (std::vector<double>{1, 0.5}));
}

TEST(Variables, InsideATextTheyAreText) {
  const Checked checked =
      check_text(pipeline("{n: 3, unit: min}", "map/voxels",
                          "window: \"${n} ${unit}\", note: \"$${n} costs $5, $$3\""));
  ASSERT_TRUE(checked.plan) << checked.text;
  EXPECT_EQ(std::get<double>(checked.parameter("it", "window")), 180.0);
  EXPECT_EQ(std::get<std::string>(checked.parameter("it", "note")), "${n} costs $5, $3");
}

TEST(Variables, MayBeMadeFromOthersAndComeBeforeTheEnvironment) {
  setenv("STOPE_TEST_NOTE", "from the environment", 1);
  setenv("STOPE_TEST_OTHER", "never", 1);
  const Checked checked =
      check_text(pipeline("{STOPE_TEST_OTHER: a var, both: \"${STOPE_TEST_NOTE}, "
                          "${STOPE_TEST_OTHER}\"}",
                          "map/voxels", "note: \"${both}\""));
  ASSERT_TRUE(checked.plan) << checked.text;
  EXPECT_EQ(std::get<std::string>(checked.parameter("it", "note")), "from the environment, a var");
  EXPECT_EQ(checked.plan->vars.at("both"), "from the environment, a var");
}

TEST(Variables, NullLeavesAnOptionalParameterOut) {
  const Checked checked =
      check_text(pipeline("{nothing: null}", "map/voxels", "note: \"${nothing}\""));
  ASSERT_TRUE(checked.plan) << checked.text;
  EXPECT_TRUE(std::holds_alternative<std::monostate>(checked.parameter("it", "note")));
}

TEST(Variables, AWholeStageCanBeOne) {
  const Checked checked = check_text(
      "stope: 1\nvars: {source: {use: source/synthetic_pit, params: {rings: 64}}}\n"
      "stages: {pit: \"${source}\"}\noutputs: {t.tum: pit}\n");
  ASSERT_TRUE(checked.plan) << checked.text;
  EXPECT_EQ(std::get<std::int64_t>(checked.parameter("pit", "rings")), 64);
}

TEST(Variables, ABrokenOneIsReportedWhereItIsWrittenAndOnlyOnce) {
  const Checked checked = check_text(pipeline("{a: \"${nowhere}\"}", "map/voxels",
                                              "window: \"${a}\", speed: \"${a}\", note: \"${a}\""));
  EXPECT_EQ(checked.text,
            "pit.yaml:2:11: error[P040]: The variable 'nowhere' is defined neither under vars: nor "
            "in the environment. Add 'nowhere: …' under vars:.\n");
}

}  // namespace
}  // namespace stope
