#include "framework/pipeline/parameters.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "checked.hpp"
#include "framework/pipeline/parameter_text.hpp"

namespace stope {
namespace {

Checked voxels(const std::string& params, const std::vector<std::string>& overrides = {}) {
  return check_text(
      "stope: 1\nstages:\n  pit: {use: source/synthetic_pit}\n"
      "  it: {use: map/voxels, in: {scans: pit, trajectory: pit}, params: {" +
          params + "}}\n",
      overrides);
}

TEST(Parameters, TravelInSiUnits) {
  const Checked checked = voxels(
      "speed: 36 km/h, area: 2 ha, yaw: 90 deg, window: 1 min, memory: 2 GiB, share: 25 %, "
      "levels: 4.0, dense: true, weights: [1, 10 %]");
  ASSERT_TRUE(checked.plan) << checked.text;
  EXPECT_EQ(std::get<double>(checked.parameter("it", "speed")), 10.0);
  EXPECT_EQ(std::get<double>(checked.parameter("it", "area")), 20000.0);
  EXPECT_DOUBLE_EQ(std::get<double>(checked.parameter("it", "yaw")), std::numbers::pi / 2);
  EXPECT_EQ(std::get<double>(checked.parameter("it", "window")), 60.0);
  EXPECT_EQ(std::get<std::int64_t>(checked.parameter("it", "memory")), 2147483648);
  EXPECT_EQ(std::get<double>(checked.parameter("it", "share")), 0.25);
  EXPECT_EQ(std::get<std::int64_t>(checked.parameter("it", "levels")), 4);
  EXPECT_TRUE(std::get<bool>(checked.parameter("it", "dense")));
  EXPECT_EQ(std::get<std::vector<double>>(checked.parameter("it", "weights")),
            (std::vector<double>{1, 0.1}));
}

TEST(Parameters, WhatIsNotWrittenKeepsItsDefault) {
  const Checked checked = voxels("");
  ASSERT_TRUE(checked.plan) << checked.text;
  EXPECT_EQ(std::get<std::string>(checked.parameter("it", "mode")), "mean");
  EXPECT_TRUE(std::holds_alternative<std::monostate>(checked.parameter("it", "note")));
}

TEST(Parameters, TheTypeDecidesNotTheQuotes) {
  const Checked checked = voxels("window: \"3 s\", note: 42, dense: 'true'");
  ASSERT_TRUE(checked.plan) << checked.text;
  EXPECT_EQ(std::get<double>(checked.parameter("it", "window")), 3.0);
  EXPECT_EQ(std::get<std::string>(checked.parameter("it", "note")), "42");
}

TEST(Parameters, ThoseOfAMemberApplyToItAlone) {
  const std::string text =
      "stope: 1\nstages:\n  pit: {use: source/synthetic_pit}\n"
      "  cloud: {use: map/point_cloud, in: {scans: pit, trajectory: pit}}\n"
      "  grid: {use: rasterizer/drivable, in: cloud, params: {resolution: 1 m, "
      "rasterizer/drivable: {slope: 10 %}, rasterizer/height_difference: {height: 2 m, "
      "resolution: 20 cm}}}\n";
  const Checked drivable = check_text(text);
  ASSERT_FALSE(drivable.plan);  // a slope is an angle
  const Checked height = check_text(
      text, {"grid.use=rasterizer/height_difference", "grid.rasterizer/drivable.slope=10 deg"});
  ASSERT_TRUE(height.plan) << height.text;
  EXPECT_EQ(std::get<double>(height.parameter("grid", "height")), 2.0);
  EXPECT_EQ(std::get<double>(height.parameter("grid", "resolution")), 0.2);
  const Checked set =
      check_text(text, {"grid.use=rasterizer/height_difference",
                        "grid.rasterizer/drivable.slope=10 deg", "grid.resolution=3"});
  ASSERT_TRUE(set.plan) << set.text;
  EXPECT_EQ(std::get<double>(set.parameter("grid", "resolution")), 3.0);
}

TEST(Parameters, ValuesReadAsTheyAreWritten) {
  EXPECT_EQ(value_text(ParameterValue{2.5}, "m"), "2.5 m");
  EXPECT_EQ(value_text(ParameterValue{std::int64_t{3}}, ""), "3");
  EXPECT_EQ(value_text(ParameterValue{std::vector<double>{1, 2}}, "m"), "[1 m, 2 m]");
  EXPECT_EQ(value_text(ParameterValue{std::string("mean")}, ""), "'mean'");
}

}  // namespace
}  // namespace stope
