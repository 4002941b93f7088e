#include "framework/plugins/manifest_check.hpp"

#include <gtest/gtest.h>

#include <functional>

#include "framework/plugins/plugin_file.hpp"
#include "tests/framework/plugins/stage_info_samples.hpp"

namespace stope {
namespace {

/// What is said of a manifest whose first stage is changed.
std::string complaint(const std::function<void(StageInfo&)>& change) {
  Manifest manifest = full_manifest();
  manifest.stages.pop_back();
  change(manifest.stages[0]);
  try {
    check_manifest(manifest);
  } catch (const PluginRefused& refused) {
    EXPECT_EQ(refused.status(), PluginStatus::kInvalid);
    return refused.what();
  }
  return "";
}

void expect_part(const std::string& text, const std::string& part) {
  EXPECT_NE(text.find(part), std::string::npos) << "'" << text << "' lacks '" << part << "'";
}

TEST(ManifestCheck, AcceptsWhatIsRight) {
  EXPECT_EQ(complaint([](StageInfo&) {}), "");
}

TEST(ManifestCheck, NamesTheStageAndThePart) {
  EXPECT_EQ(complaint([](StageInfo& s) { s.inputs.push_back(s.inputs[0]); }),
            "Its stage 'acme/everything' is declared wrongly: two inputs are named 'scans'.");
}

TEST(ManifestCheck, RefusesIdsOfAnotherForm) {
  for (const char* id : {"", "watershed", "topology/", "/watershed", "Topology/watershed",
                         "topology/water-shed", "topology/a/b", "topology/water shed"}) {
    expect_part(complaint([id](StageInfo& s) { s.id = id; }), "not of the form family/name");
  }
}

TEST(ManifestCheck, RefusesPortsThatCannotBe) {
  expect_part(complaint([](StageInfo& s) { s.inputs[0].name = "Scans"; }), "snake_case");
  expect_part(complaint([](StageInfo& s) { s.outputs[0].type = "Sector"; }), "vendor/Name@1");
  expect_part(complaint([](StageInfo& s) { s.outputs[0].type = "acme/Sector@one"; }),
              "vendor/Name@1");
  expect_part(complaint([](StageInfo& s) { s.outputs.clear(); }), "must call ports()");
  expect_part(complaint([](StageInfo& s) { s.outputs.clear(), s.inputs.clear(); }), "no ports");
  expect_part(complaint([](StageInfo& s) { s.outputs[0].type = "stope/Path@1"; }),
              "it writes files");
}

TEST(ManifestCheck, RefusesParametersThatCannotBe) {
  expect_part(complaint([](StageInfo& s) { s.parameters[0].name = "2nd"; }), "snake_case");
  expect_part(complaint([](StageInfo& s) { s.parameters[1].name = "real"; }), "two parameters");
  expect_part(complaint([](StageInfo& s) { s.parameters[0].default_value.emplace<bool>(true); }),
              "kind");
  expect_part(complaint([](StageInfo& s) { s.parameters[0].default_value.emplace<double>(2.5); }),
              "the default 2.5 of 'real' is outside its own limits");
  expect_part(complaint([](StageInfo& s) { s.parameters[0].limits = between(2, 1); }),
              "leave no value");
  expect_part(
      complaint([](StageInfo& s) { s.parameters[4].default_value.emplace<std::string>("c"); }),
      "the default 'c' of 'text' is not one of its choices");
}

TEST(ManifestCheck, RefusesAPluginWithoutStages) {
  EXPECT_THROW(check_manifest({"acme", "1.0.0", {}}), PluginRefused);
}

}  // namespace
}  // namespace stope
