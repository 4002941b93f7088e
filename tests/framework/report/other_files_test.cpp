#include "framework/report/other_files.hpp"

#include <gtest/gtest.h>

#include "tests/framework/report/made_run.hpp"

namespace stope::report {
namespace {

namespace fs = std::filesystem;

TEST(OtherFiles, AreThoseThatNobodyOwns) {
  const made::Folder folder;
  for (const char* name :
       {"map.yaml", "old.yaml", "maps/prior.yaml", "maps/older.yaml", "deep/er/still/old.txt",
        "live/000000.png", "live/000009.png", "live/notes.txt", ".map.yaml.stope-part"})
    made::put_text(folder.path / name, "text");
  fs::create_directory_symlink(folder.path / "deep", folder.path / "link");
  EXPECT_EQ(
      other_files(folder.path, {"map.yaml", "maps/prior.yaml", "live", "live/000000.png"}),
      (std::vector<std::string>{"deep/", "link", "live/notes.txt", "maps/older.yaml", "old.yaml"}));
}

TEST(OtherFiles, AreNoneInAFolderThatIsNotThere) {
  const made::Folder folder;
  EXPECT_TRUE(other_files(folder.path / "gone", {}).empty());
}

}  // namespace
}  // namespace stope::report
