#include "framework/cache/file_digests.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <thread>

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
  /// Waits until what was written counts as settled. Longer than the system's clock for files takes
  /// to go on.
  static void settle() { std::this_thread::sleep_for(3 * kSettling); }
  /// Whether a file's digest is known: who must read is stopped.
  static bool is_known(FileDigests& digests, const fs::path& file) {
    const std::atomic<bool> stop = true;
    try {
      digests.of(file, &stop);
    } catch (const Cancelled&) {
      return false;
    }
    return true;
  }
  static constexpr auto kSettling = std::chrono::milliseconds(20);
  testing::MemoryContext context_;
  fs::path folder_ = context_.temporary_folder();
  FileDigests digests_{folder_ / "table", kSettling};
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
  EXPECT_EQ(digests_.of(folder_ / "none"), kNothingThere);
  write("empty", "");
  EXPECT_NE(digests_.of(folder_ / "empty"), kNothingThere);
}

TEST_F(FileDigestsTest, SeesAChangeOfTheSameSize) {
  write("a", "ore");
  settle();
  const Digest before = digests_.of(folder_ / "a");
  write("a", "tin");
  EXPECT_NE(digests_.of(folder_ / "a"), before);
  write("a", "ore");
  EXPECT_EQ(digests_.of(folder_ / "a"), before);
}

TEST_F(FileDigestsTest, DoesNotReadAgainWhatHasNotChanged) {
  write("a", "ore");
  settle();
  const Digest before = digests_.of(folder_ / "a");
  digests_.save();
  FileDigests next(folder_ / "table");
  EXPECT_TRUE(is_known(next, folder_ / "a"));
  EXPECT_EQ(next.of(folder_ / "a"), before);
}

TEST_F(FileDigestsTest, SeesAChangeWhoseTimeWasSetBack) {
  // As tar does: the time of the archive, and, with luck, the inode of the file before.
  write("a", "ore");
  const auto time = fs::file_time_type::clock::now() - std::chrono::hours(1);
  fs::last_write_time(folder_ / "a", time);
  settle();
  const Digest before = digests_.of(folder_ / "a");
  EXPECT_TRUE(is_known(digests_, folder_ / "a"));
  std::fstream(folder_ / "a", std::ios::in | std::ios::out) << "tin";
  fs::last_write_time(folder_ / "a", time);
  EXPECT_NE(digests_.of(folder_ / "a"), before);
}

TEST_F(FileDigestsTest, DoesNotTrustWhatHasJustChangedHoweverOldItSaysItIs) {
  write("a", "ore");
  fs::last_write_time(folder_ / "a", fs::file_time_type::clock::now() - std::chrono::hours(1));
  FileDigests digests(folder_ / "table");
  digests.of(folder_ / "a");
  EXPECT_FALSE(is_known(digests, folder_ / "a"));
}

TEST_F(FileDigestsTest, TellsWhatHasChangedSinceItWasDigested) {
  write("a", "ore");
  write("x/1.pcd", "first");
  settle();
  digests_.of(folder_ / "a");
  digests_.of(folder_ / "x");
  digests_.of(folder_ / "none");
  EXPECT_TRUE(digests_.is_as_seen(folder_ / "a"));
  EXPECT_TRUE(digests_.is_as_seen(folder_ / "x"));
  EXPECT_TRUE(digests_.is_as_seen(folder_ / "none"));
  write("a", "tin");
  write("a", "ore");
  EXPECT_FALSE(digests_.is_as_seen(folder_ / "a")) << "swapped and put back";
  digests_.of(folder_ / "a");
  EXPECT_FALSE(digests_.is_as_seen(folder_ / "a")) << "a later look must not excuse it";
  write("x/2.pcd", "second");
  EXPECT_FALSE(digests_.is_as_seen(folder_ / "x"));
  write("none", "some");
  EXPECT_FALSE(digests_.is_as_seen(folder_ / "none"));
  EXPECT_FALSE(digests_.is_as_seen(folder_ / "never asked about"));
}

TEST_F(FileDigestsTest, ADamagedTableIsAnEmptyOne) {
  write("a", "ore");
  settle();
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
