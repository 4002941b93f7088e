#include "framework/report/artefact_writer.hpp"

#include <gtest/gtest.h>

#include "tests/framework/report/made_run.hpp"

namespace stope::report {
namespace {

namespace fs = std::filesystem;
using made::artefact;
using made::item;
using made::text_of;

void write_frames(const fs::path& folder, const std::vector<std::uint64_t>& indices,
                  const std::string& text) {
  RunDirectory directory(folder);
  ArtefactWriter writer(directory, {"live.png", 0, true, {}});
  for (const std::uint64_t index : indices)
    writer.write(item(artefact({{"png", text}, {"pgw", "world"}}), index));
  writer.close();
  writer.commit();
}

TEST(ArtefactWriter, PutsAStreamIntoAFolderOfNumberedFiles) {
  const made::Folder folder;
  write_frames(folder.path, {0, 1, 7}, "new");
  EXPECT_EQ(made::files_below(folder.path / "outputs"),
            (std::vector<std::string>{"live/000000.pgw", "live/000000.png", "live/000001.pgw",
                                      "live/000001.png", "live/000007.pgw", "live/000007.png"}));
}

TEST(ArtefactWriter, ReplacesAnEarlierStreamAndKeepsForeignFilesInItsFolder) {
  const made::Folder folder;
  write_frames(folder.path, {0, 1, 2}, "old");
  made::put_text(folder.path / "outputs/live/notes.txt", "mine");
  made::put_text(folder.path / "outputs/live/0001.png", "mine too");
  write_frames(folder.path, {0}, "new");
  EXPECT_EQ(made::files_below(folder.path / "outputs"),
            (std::vector<std::string>{"live/000000.pgw", "live/000000.png", "live/0001.png",
                                      "live/notes.txt"}));
  EXPECT_EQ(text_of(folder.path / "outputs/live/000000.png"), "new");
}

TEST(ArtefactWriter, LeavesAnEarlierStreamAloneUntilCommit) {
  const made::Folder folder;
  write_frames(folder.path, {0, 1}, "old");
  {
    RunDirectory directory(folder.path);
    ArtefactWriter writer(directory, {"live.png", 0, true, {}});
    writer.write(item(artefact({{"png", "new"}})));
    EXPECT_EQ(text_of(folder.path / "outputs/live/000000.png"), "old");
  }
  EXPECT_EQ(made::files_below(folder.path / "outputs").size(), 4U);
  EXPECT_EQ(text_of(folder.path / "outputs/live/000001.png"), "old");
}

TEST(ArtefactWriter, MakesAnEmptyFolderOfAnEmptyStream) {
  const made::Folder folder;
  write_frames(folder.path, {}, "");
  EXPECT_TRUE(fs::is_directory(folder.path / "outputs/live"));
}

TEST(ArtefactWriter, RefusesTwoOutputsThatWouldWriteOneFile) {
  const made::Folder folder;
  RunDirectory directory(folder.path);
  ArtefactWriter map(directory, {"map.yaml", 0, false, {}});
  ArtefactWriter picture(directory, {"map.pgm", 0, false, {}});
  try {
    map.write(item(artefact({{"yaml", "a"}, {"pgm", "b"}})));
    FAIL() << "the companion took another output's place";
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(),
                 "the outputs map.pgm and map.yaml would both write outputs/map.pgm. Give one "
                 "another name.");
  }
}

TEST(ArtefactWriter, RefusesNamesAndLinksThatLeadOut) {
  const made::Folder folder, elsewhere;
  RunDirectory directory(folder.path);
  EXPECT_THROW(ArtefactWriter(directory, {"../escape.png", 0, false, {}}), Error);
  fs::create_directory_symlink(elsewhere.path, folder.path / "outputs/link");
  EXPECT_THROW(ArtefactWriter(directory, {"link/map.png", 0, false, {}}), Error);
  ArtefactWriter writer(directory, {"map.png", 0, false, {}});
  EXPECT_THROW(writer.write(item(artefact({{"png", "a"}, {"../../x", "b"}}))), Error);
  EXPECT_TRUE(made::files_below(elsewhere.path).empty());
}

TEST(ArtefactWriter, ReplacesASymbolicLinkInsteadOfWritingThroughIt) {
  const made::Folder folder, elsewhere;
  made::put_text(elsewhere.path / "precious.png", "precious");
  RunDirectory directory(folder.path);
  fs::create_symlink(elsewhere.path / "precious.png", folder.path / "outputs/map.png");
  ArtefactWriter writer(directory, {"map.png", 0, false, {}});
  writer.write(item(artefact({{"png", "new"}})));
  writer.close();
  writer.commit();
  EXPECT_EQ(text_of(elsewhere.path / "precious.png"), "precious");
  EXPECT_EQ(text_of(folder.path / "outputs/map.png"), "new");
}

TEST(ArtefactWriter, RefusesAFolderInAFilesPlaceAndTheOtherWayRound) {
  const made::Folder folder;
  made::put_text(folder.path / "outputs/map.png/inside.txt", "mine");
  made::put_text(folder.path / "outputs/live", "mine");
  RunDirectory directory(folder.path);
  EXPECT_THROW(ArtefactWriter(directory, {"map.png", 0, false, {}}), Error);
  EXPECT_THROW(ArtefactWriter(directory, {"live.png", 0, true, {}}), Error);
}

TEST(ArtefactWriter, SaysThatAnExportGaveNothing) {
  const made::Folder folder;
  RunDirectory directory(folder.path);
  ArtefactWriter writer(directory, {"map.png", 0, false, {}});
  EXPECT_THROW(writer.write(item(Artefact{})), Error);
  EXPECT_THROW(writer.close(), Error);
}

}  // namespace
}  // namespace stope::report
