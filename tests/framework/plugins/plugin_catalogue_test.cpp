#include "framework/plugins/plugin_catalogue.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "stope/payloads.hpp"
#include "stope/testing/memory_context.hpp"
#include "stope/testing/memory_ports.hpp"

namespace stope {
namespace {

PluginOptions options_for(const std::filesystem::path& place) {
  PluginOptions options;
  options.search.places = {place};
  return options;
}

TEST(PluginCatalogue, MakesAStageOfAPluginItFound) {
  const PluginCatalogue catalogue(options_for(GOOD_PLUGIN));
  ASSERT_EQ(catalogue.files().size(), 1U);
  EXPECT_EQ(catalogue.files()[0].sentence, "");
  EXPECT_EQ(catalogue.files()[0].plugin_id, "good");
  EXPECT_EQ(catalogue.files()[0].plugin_version, "1.2.3");
  EXPECT_EQ(catalogue.files()[0].build_id.size(), 40U);

  const StageRecord* record = catalogue.find("hostile/good");
  ASSERT_NE(record, nullptr);
  EXPECT_EQ(record->info.parameters.at(0).unit, "m");

  const auto stage = catalogue.create("hostile/good");
  ASSERT_TRUE(stage->set_parameter(0, 3.0));
  const auto measures = std::make_shared<const Measures>(Measures{{"height"}, {2.0}, {"m"}, {""}});
  const AnyItem input{0, 0, std::make_shared<testing::MemoryPayload<Measures>>(measures)};
  testing::MemoryContext context;
  std::shared_ptr<const void> output[1];
  ASSERT_TRUE(stage->apply({&input, 1}, context, output));
  EXPECT_EQ(static_cast<const Measures*>(output[0].get())->values, std::vector{6.0});
}

TEST(PluginCatalogue, TellsPluginsWithoutABuildIdFromOneAnother) {
  testing::MemoryContext context;
  const auto file = context.temporary_folder() / "plugin.so";
  // As `-Wl,--build-id=none` leaves it, as far as anybody can tell: a note of another owner.
  std::ifstream stream(GOOD_PLUGIN, std::ios::binary);
  std::string bytes(std::istreambuf_iterator<char>(stream), {});
  const std::string head{"\x14\0\0\0\x03\0\0\0GNU", 11};  // 20 bytes, type 3
  const std::size_t note = bytes.find(head);
  ASSERT_NE(note, std::string::npos);
  bytes[note + head.size() - 1] = 'X';
  const auto build_of = [&](const std::string& content) {
    std::ofstream(file, std::ios::binary) << content;
    const PluginCatalogue catalogue(options_for(file));
    EXPECT_EQ(catalogue.files().at(0).sentence, "");
    const StageRecord* record = catalogue.find("hostile/good");
    return record ? record->build_id : "";
  };
  const std::string first = build_of(bytes);
  EXPECT_EQ(first.size(), 32U) << first;
  EXPECT_EQ(build_of(bytes), first);
  EXPECT_NE(build_of(bytes + "rebuilt"), first);
}

TEST(PluginCatalogue, OpensNoLibraryWhoseManifestIsKept) {
  testing::MemoryContext context;
  const auto file = context.temporary_folder() / "good.so";
  std::filesystem::copy_file(GOOD_PLUGIN, file);
  PluginOptions options = options_for(file);
  options.manifests = context.temporary_folder() / "manifests";
  EXPECT_FALSE(PluginCatalogue(options).files().at(0).cached);

  options.probe_limit = std::chrono::milliseconds(0);  // no probe can succeed
  const PluginCatalogue warm(options);
  EXPECT_TRUE(warm.files().at(0).cached);
  EXPECT_EQ(warm.files().at(0).status, PluginStatus::kUsable);
  EXPECT_NE(warm.create("hostile/good"), nullptr);
}

TEST(PluginCatalogue, RefusesAFileThatWasReplacedAfterItWasJudged) {
  testing::MemoryContext context;
  const auto file = context.temporary_folder() / "good.so";
  std::filesystem::copy_file(GOOD_PLUGIN, file);
  const PluginCatalogue catalogue(options_for(file));
  std::ofstream(file, std::ios::app) << "more";
  EXPECT_THROW(catalogue.create("hostile/good"), Error);
}

TEST(PluginCatalogue, SaysThatNoPluginOffersAStage) {
  const PluginCatalogue catalogue(options_for(GOOD_PLUGIN));
  EXPECT_EQ(catalogue.find("hostile/absent"), nullptr);
  EXPECT_THROW(catalogue.create("hostile/absent"), Error);
}

}  // namespace
}  // namespace stope
