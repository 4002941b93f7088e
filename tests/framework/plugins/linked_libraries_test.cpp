// Results must not pass for those of another build of a library that a plugin is linked with.
#include "framework/plugins/linked_libraries.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "framework/plugins/plugin_catalogue.hpp"
#include "stope/testing/memory_context.hpp"

namespace stope {
namespace {

namespace fs = std::filesystem;

class LinkedLibrariesTest : public ::testing::Test {
 protected:
  LinkedLibrariesTest() {
    fs::copy_file(LINKED_PLUGIN, folder_ / "linked.so");
    put_companion(FIRST_COMPANION);
    options_.search.places = {folder_ / "linked.so"};
    options_.manifests = folder_ / "manifests";
  }

  void put_companion(const char* build) {
    fs::copy_file(build, folder_ / "new");
    fs::rename(folder_ / "new", folder_ / "libcompanion.so");
  }

  struct Seen {
    std::string build_id, libraries;
    bool cached = false;
  };
  Seen look() const {
    const PluginCatalogue catalogue(options_);
    EXPECT_EQ(catalogue.files().at(0).sentence, "");
    const StageRecord* record = catalogue.find("linked/accompanied");
    if (!record) return {};
    return {record->build_id, record->libraries, catalogue.files()[0].cached};
  }

  testing::MemoryContext context_;
  fs::path folder_ = context_.temporary_folder();
  PluginOptions options_;
};

TEST_F(LinkedLibrariesTest, AreKnownWithoutOpeningThePluginAgain) {
  const Seen first = look();
  EXPECT_EQ(first.libraries.size(), 32U);
  EXPECT_FALSE(first.cached);
  const Seen again = look();
  EXPECT_TRUE(again.cached);
  EXPECT_EQ(again.libraries, first.libraries);
}

TEST_F(LinkedLibrariesTest, OfAnotherBuildAreFoundOut) {
  const Seen first = look();
  put_companion(SECOND_COMPANION);
  const Seen second = look();
  EXPECT_EQ(second.build_id, first.build_id);
  EXPECT_NE(second.libraries, first.libraries);
  EXPECT_FALSE(second.cached);
  put_companion(FIRST_COMPANION);
  EXPECT_EQ(look().libraries, first.libraries);
}

TEST_F(LinkedLibrariesTest, ThatAreGoneMakeThePluginUnusable) {
  look();
  fs::remove(folder_ / "libcompanion.so");
  const PluginCatalogue catalogue(options_);
  EXPECT_EQ(catalogue.files().at(0).status, PluginStatus::kFailed);
  EXPECT_NE(catalogue.files()[0].sentence.find("libcompanion.so"), std::string::npos);
}

TEST_F(LinkedLibrariesTest, CountThoseOfLibraries) {
  // Neither is named by the plugin itself; the C library has a build id on Debian.
  const PluginCatalogue catalogue(options_);
  catalogue.create("linked/accompanied");
  std::vector<std::string> names;
  for (const LinkedLibrary& library : linked_libraries(folder_ / "linked.so")) {
    names.push_back(fs::path(library.file).filename().string());
    EXPECT_GE(library.build.size(), 32U) << library.file;
    EXPECT_EQ(library.size, fs::file_size(library.file));
  }
  EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
  for (const char* name : {"libc.so.6", "libstdc++.so.6", "libcompanion.so"})
    EXPECT_EQ(std::count(names.begin(), names.end(), name), 1) << name;
  for (const std::string& name : names) EXPECT_FALSE(name.starts_with("libstope")) << name;
}

TEST_F(LinkedLibrariesTest, AreLookedForAnewUnderAnotherSearchPath) {
  look();
  ::setenv("LD_LIBRARY_PATH", folder_.c_str(), 1);
  const Seen elsewhere = look();
  ::unsetenv("LD_LIBRARY_PATH");
  EXPECT_FALSE(elsewhere.cached);
}

}  // namespace
}  // namespace stope
