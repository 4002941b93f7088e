#include "framework/cache/store_folder.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fstream>
#include <vector>

#include "stope/error.hpp"
#include "stope/testing/memory_context.hpp"

namespace stope {
namespace {

namespace fs = std::filesystem;

class StoreFolderTest : public ::testing::Test {
 protected:
  testing::MemoryContext context_;
  fs::path folder_ = context_.temporary_folder() / "place";
};

TEST_F(StoreFolderTest, IsMadeWhereNothingIsOrAnEmptyFolder) {
  EXPECT_FALSE(is_store(folder_));
  EXPECT_EQ(why_no_store(folder_), "");
  EXPECT_FALSE(fs::exists(folder_)) << "to ask must make nothing";
  make_store(folder_);
  EXPECT_TRUE(is_store(folder_));
  make_store(folder_);
  EXPECT_EQ(why_no_store(folder_), "");
  fs::create_directory(context_.temporary_folder() / "empty");
  make_store(context_.temporary_folder() / "empty");
  EXPECT_TRUE(is_store(context_.temporary_folder() / "empty"));
}

TEST_F(StoreFolderTest, AFolderOfSomethingElseIsLeftAsItIs) {
  fs::create_directories(folder_ / "objects");
  fs::create_directories(folder_ / "new");
  fs::create_directories(folder_ / "stages");
  std::ofstream(folder_ / "000000.bin") << "a scan";
  EXPECT_FALSE(is_store(folder_));
  EXPECT_NE(why_no_store(folder_).find("is not empty and is no store of Stope"), std::string::npos);
  EXPECT_THROW(make_store(folder_), Error);
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()), 4);
}

TEST_F(StoreFolderTest, AFileIsNoStore) {
  std::ofstream(folder_) << "a file";
  EXPECT_FALSE(is_store(folder_));
  EXPECT_NE(why_no_store(folder_).find("is no folder"), std::string::npos);
}

TEST_F(StoreFolderTest, AStoreFromBeforeThereWereMarksIsOne) {
  for (const char* part : {"objects", "new", "stages", "partial"})
    fs::create_directories(folder_ / part);
  std::ofstream(folder_ / "digests") << "a table";
  EXPECT_TRUE(is_store(folder_));
  make_store(folder_);
  // Marked now, so that it stays one whatever else comes into it.
  std::ofstream(folder_ / "notes.txt") << "mine";
  EXPECT_TRUE(is_store(folder_));
}

TEST_F(StoreFolderTest, SeveralProcessesMayMakeIt) {
  constexpr int kProcesses = 4, kRounds = 50;
  std::vector<pid_t> children;
  for (int process = 0; process < kProcesses; ++process) {
    const pid_t child = ::fork();
    if (child == 0) {
      try {
        for (int round = 0; round < kRounds; ++round) {
          const fs::path folder = folder_ / std::to_string(round);
          make_store(folder);
          fs::create_directories(folder / "new");
        }
        ::_exit(0);
      } catch (const Error&) {
        ::_exit(1);
      }
    }
    children.push_back(child);
  }
  for (const pid_t child : children) {
    int status = 0;
    ::waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
  }
}

}  // namespace
}  // namespace stope
