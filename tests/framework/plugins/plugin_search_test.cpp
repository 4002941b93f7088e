#include "framework/plugins/plugin_search.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <map>

#include "stope/testing/memory_context.hpp"

namespace stope {
namespace {

namespace fs = std::filesystem;

class PluginSearchTest : public ::testing::Test {
 protected:
  fs::path make(const fs::path& relative) const {
    fs::create_directories(root_ / relative);
    return root_ / relative;
  }
  Environment environment() const {
    return [variables = variables_](const std::string& name) -> std::optional<std::string> {
      const auto found = variables.find(name);
      if (found == variables.end()) return std::nullopt;
      return found->second;
    };
  }

  testing::MemoryContext context_;
  fs::path root_ = fs::canonical(context_.temporary_folder());
  fs::path executable_ = root_ / "prefix" / "bin" / "stope";
  std::map<std::string, std::string> variables_;
};

TEST_F(PluginSearchTest, SearchesFromTheMostToTheLeastSpecific) {
  const fs::path first = make("first"), second = make("second"), third = make("third"),
                 fourth = make("fourth"), user = make("data/stope/plugins"),
                 installed = make("prefix/lib/stope/plugins");
  make("prefix/bin");
  variables_["STOPE_PLUGIN_PATH"] = third.string() + "::" + fourth.string();
  variables_["XDG_DATA_HOME"] = (root_ / "data").string();
  const PluginSearch search = plugin_search({second, first}, executable_, environment());
  EXPECT_EQ(search.places, (std::vector{second, first, third, fourth, user, installed}));
  EXPECT_TRUE(search.warnings.empty());
}

TEST_F(PluginSearchTest, AHomeWithoutXdgVariablesWillDo) {
  const fs::path user = make("home/.local/share/stope/plugins");
  variables_["HOME"] = (root_ / "home").string();
  variables_["XDG_DATA_HOME"] = "relative/values/are/ignored";
  EXPECT_EQ(plugin_search({}, executable_, environment()).places, std::vector{user});
  EXPECT_EQ(manifest_folder(environment()), root_ / "home/.cache/stope/manifests");
  variables_["XDG_CACHE_HOME"] = (root_ / "cache").string();
  EXPECT_EQ(manifest_folder(environment()), root_ / "cache/stope/manifests");
  variables_.clear();
  EXPECT_EQ(manifest_folder(environment()), std::nullopt);
}

TEST_F(PluginSearchTest, WarnsOfNamedFoldersThatAreNotThereAndOfNoOthers) {
  variables_["STOPE_PLUGIN_PATH"] = "/nowhere/at/all:plugins";
  variables_["HOME"] = "/nowhere";
  const PluginSearch search = plugin_search({root_ / "gone"}, executable_, environment());
  EXPECT_TRUE(search.places.empty());
  ASSERT_EQ(search.warnings.size(), 3U);
  EXPECT_EQ(search.warnings[0], "There is no plugin folder " + (root_ / "gone").string() +
                                    " (--plugin-path names it); it is skipped.");
  EXPECT_EQ(search.warnings[1],
            "There is no plugin folder /nowhere/at/all (STOPE_PLUGIN_PATH names it); it is "
            "skipped.");
  EXPECT_NE(search.warnings[2].find("not an absolute path"), std::string::npos);
}

TEST_F(PluginSearchTest, FindsEachLibraryOnceInOrderOfNames) {
  const fs::path folder = make("plugins"), other = make("others");
  for (const char* name : {"b.so", "a.so", "notes.txt", "libc.so.6"}) std::ofstream(folder / name);
  fs::create_directories(folder / "folder.so");
  fs::create_symlink(folder / "a.so", other / "alias.so");
  PluginSearch search = plugin_search({other, folder, other}, executable_, environment());
  EXPECT_EQ(plugin_candidates(search), (std::vector{other / "alias.so", folder / "b.so"}));
}

TEST_F(PluginSearchTest, ASingleLibraryCanBeNamed) {
  const fs::path file = make("plugins") / "a.so";
  std::ofstream(file).close();
  PluginSearch search = plugin_search({file}, executable_, environment());
  EXPECT_EQ(plugin_candidates(search), std::vector{file});
}

}  // namespace
}  // namespace stope
