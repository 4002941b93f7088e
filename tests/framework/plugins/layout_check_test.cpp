#include "framework/plugins/layout_check.hpp"

#include <gtest/gtest.h>

#include "framework/plugins/plugin_file.hpp"
#include "stope/layout.hpp"
#include "stope/payloads/measures.hpp"

namespace stope {
namespace {

Manifest manifest_with(const PortInfo& input) {
  StageInfo stage;
  stage.id = "acme/stage";
  stage.inputs = {input};
  return {"acme", "1.0.0", {stage}};
}

TEST(LayoutCheck, KnowsTheSdksOwnTypes) {
  EXPECT_EQ(sdk_layouts().at("stope/Measures@1"), layout_hash<Measures>());
  EXPECT_EQ(sdk_layouts().size(), 20U);
}

TEST(LayoutCheck, JudgesTypesOfTheSdkAlone) {
  const auto layouts = sdk_layouts();
  EXPECT_NO_THROW(check_layouts(
      manifest_with({"in", "stope/Measures@1", layout_hash<Measures>(), true, true, ""}), layouts));
  EXPECT_NO_THROW(
      check_layouts(manifest_with({"in", "acme/Sector@1", 1, true, true, ""}), layouts));
  EXPECT_THROW(check_layouts(manifest_with({"in", "stope/Measures@1", 1, true, true, ""}), layouts),
               PluginRefused);
  EXPECT_THROW(check_layouts(manifest_with({"in", "stope/Nothing@1", 1, true, true, ""}), layouts),
               PluginRefused);
}

}  // namespace
}  // namespace stope
