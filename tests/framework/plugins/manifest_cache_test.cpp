#include "framework/plugins/manifest_cache.hpp"

#include <gtest/gtest.h>

#include <fstream>

#include "stope/testing/memory_context.hpp"
#include "tests/framework/plugins/stage_info_samples.hpp"

namespace stope {
namespace {

namespace fs = std::filesystem;

class ManifestCacheTest : public ::testing::Test {
 protected:
  fs::path only_file() const {
    const fs::directory_iterator entry(folder_);
    return entry->path();
  }

  testing::MemoryContext context_;
  fs::path folder_ = context_.temporary_folder() / "made" / "when needed";
  FileIdentity identity_{"/plugins/acme.so", 1234, 5678, "abcd", ""};
};

TEST_F(ManifestCacheTest, GivesBackWhatItKept) {
  const ManifestCache cache(folder_);
  EXPECT_FALSE(cache.find(identity_));
  cache.keep(identity_, full_manifest());
  const auto manifest = cache.find(identity_);
  ASSERT_TRUE(manifest);
  EXPECT_EQ(manifest->stages.size(), 2U);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), {}), 1);
}

TEST_F(ManifestCacheTest, AnotherBuildOfTheFileIsAnotherFile) {
  const ManifestCache cache(folder_);
  cache.keep(identity_, full_manifest());
  for (const FileIdentity& other :
       {FileIdentity{"/plugins/other.so", 1234, 5678, "abcd", ""},
        FileIdentity{"/plugins/acme.so", 1235, 5678, "abcd", ""},
        FileIdentity{"/plugins/acme.so", 1234, 5679, "abcd", ""},
        FileIdentity{"/plugins/acme.so", 1234, 5678, "abce", ""},
        FileIdentity{"/plugins/acme.so", 1234, 5678, "abcd", "LD_PRELOAD=x"}}) {
    EXPECT_FALSE(cache.find(other));
  }
}

TEST_F(ManifestCacheTest, ACorruptFileIsAsGoodAsNone) {
  const ManifestCache cache(folder_);
  cache.keep(identity_, full_manifest());
  std::fstream stream(only_file(), std::ios::in | std::ios::out | std::ios::binary);
  stream.seekp(100);
  stream.put('?');
  stream.close();
  EXPECT_FALSE(cache.find(identity_));
  fs::resize_file(only_file(), 3);
  EXPECT_FALSE(cache.find(identity_));
  cache.keep(identity_, full_manifest());
  EXPECT_TRUE(cache.find(identity_));
}

TEST_F(ManifestCacheTest, AFolderThatCannotBeMadeIsNoError) {
  const fs::path file = context_.temporary_folder() / "a file";
  std::ofstream(file) << "in the way";
  const ManifestCache cache(file / "below it");
  cache.keep(identity_, full_manifest());
  EXPECT_FALSE(cache.find(identity_));
}

TEST_F(ManifestCacheTest, WithoutAFolderItKeepsNothing) {
  const ManifestCache cache(std::nullopt);
  cache.keep(identity_, full_manifest());
  EXPECT_FALSE(cache.find(identity_));
}

}  // namespace
}  // namespace stope
