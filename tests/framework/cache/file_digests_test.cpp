#include "framework/cache/file_digests.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>

#include "stope/error.hpp"
#include "stope/testing/memory_context.hpp"

namespace stope {
namespace {

namespace fs = std::filesystem;

class FileDigestsTest : public ::testing::Test {
 protected:
  void write(const fs::path& name, const std::string& text) {
    fs::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name) << text;
  }
  /// Sets a file's time so far back that it counts as settled.
  void settle(const fs::path& name, int hours = 1) {
    fs::last_write_time(folder_ / name,
                        fs::file_time_type::clock::now() - std::chrono::hours(hours));
  }
  testing::MemoryContext context_;
  fs::path folder_ = context_.temporary_folder();
  FileDigests digests_{folder_ / "table"};
};

TEST_F(FileDigestsTest, AFileIsItsBytes) {
  write("a", "ore");
  write("b", "ore");
  write("c", "rock");
  EXPECT_EQ(digests_.of(folder_ / "a"), digests_.of(folder_ / "b"));
  EXPECT_NE(digests_.of(folder_ / "a"), digests_.of(folder_ / "c"));
}

TEST_F(FileDigestsTest, AFolderIsItsNamesAndBytesWhereverItLies) {
  write("x/1.pcd", "first");
  write("x/deep/2.pcd", "second");
  write("y/1.pcd", "first");
  write("y/deep/2.pcd", "second");
  EXPECT_EQ(digests_.of(folder_ / "x"), digests_.of(folder_ / "y"));
  fs::rename(folder_ / "y/1.pcd", folder_ / "y/0.pcd");
  EXPECT_NE(digests_.of(folder_ / "x"), digests_.of(folder_ / "y"));
}

TEST_F(FileDigestsTest, WhatIsNotThereIsNothing) {
  EXPECT_EQ(digests_.of(folder_ / "none"), digests_.of(folder_ / "neither"));
}

TEST_F(FileDigestsTest, SeesAChangeOfTheSameSize) {
  write("a", "ore");
  settle("a");
  const Digest before = digests_.of(folder_ / "a");
  write("a", "tin");
  EXPECT_NE(digests_.of(folder_ / "a"), before);
  write("a", "ore");
  EXPECT_EQ(digests_.of(folder_ / "a"), before);
}

TEST_F(FileDigestsTest, DoesNotReadAgainWhatHasNotChanged) {
  write("a", "ore");
  settle("a");
  const auto time = fs::last_write_time(folder_ / "a");
  const Digest before = digests_.of(folder_ / "a");
  digests_.save();
  // Same size and time, other bytes: only who reads the file could tell.
  std::fstream(folder_ / "a", std::ios::in | std::ios::out) << "tin";
  fs::last_write_time(folder_ / "a", time);
  EXPECT_EQ(FileDigests(folder_ / "table").of(folder_ / "a"), before);
}

TEST_F(FileDigestsTest, ADamagedTableIsAnEmptyOne) {
  write("a", "ore");
  settle("a");
  const Digest right = digests_.of(folder_ / "a");
  digests_.save();
  const auto size = fs::file_size(folder_ / "table");
  for (std::uintmax_t place = 0; place < size; place += 7) {
    digests_.save();
    std::fstream table(folder_ / "table", std::ios::in | std::ios::out | std::ios::binary);
    table.seekp(static_cast<std::streamoff>(place));
    table.put('\x7f');
    table.close();
    EXPECT_EQ(FileDigests(folder_ / "table").of(folder_ / "a"), right);
  }
}

}  // namespace
}  // namespace stope
