// Pipelines that lie in folders: what they include, and what their paths are relative to.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "checked.hpp"

namespace stope {
namespace {

class Files : public testing::Test {
 protected:
  void SetUp() override {
    folder_ =
        std::filesystem::temp_directory_path() / ("stope-files-test-" + std::to_string(getpid()));
    std::filesystem::create_directories(folder_);
    // macOS and some machines have temporary folders behind links.
    folder_ = std::filesystem::canonical(folder_);
    before_ = std::filesystem::current_path();
  }
  void TearDown() override {
    std::filesystem::current_path(before_);
    std::filesystem::remove_all(folder_);
  }
  std::string write(const std::string& name, const std::string& text) {
    const auto file = folder_ / name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file) << text;
    return file.string();
  }

  std::filesystem::path folder_, before_;
};

TEST_F(Files, TheIncludingFileWins) {
  write("parts/sensors.yaml",
        "vars: {rings: 16, extent: 200 m}\n"
        "stages:\n"
        "  pit: {use: source/synthetic_pit, params: {rings: \"${rings}\", extent: \"${extent}\"}}\n"
        "  spare: {use: source/synthetic_pit}\n"
        "outputs: {t.tum: pit.trajectory, spare.tum: spare}\n");
  const Checked checked = check_file(write("main.yaml",
                                           "stope: 1\n"
                                           "include: parts/sensors.yaml\n"
                                           "vars: {rings: 64}\n"
                                           "stages:\n"
                                           "  pit: {params: {turns: 5 Hz}}\n"
                                           "  spare: null\n"
                                           "outputs: {spare.tum: ~}\n"));
  ASSERT_TRUE(checked.plan) << checked.text;
  EXPECT_EQ(checked.text, "");
  EXPECT_EQ(std::get<std::int64_t>(checked.parameter("pit", "rings")), 64);
  EXPECT_EQ(std::get<double>(checked.parameter("pit", "extent")), 200.0);
  EXPECT_EQ(std::get<double>(checked.parameter("pit", "turns")), 5.0);
  EXPECT_EQ(checked.plan->stages.size(), 2U);
  EXPECT_EQ(checked.plan->files_read.size(), 2U);
}

TEST_F(Files, TwoFilesMayIncludeTheSameThird) {
  write("common.yaml", "vars: {extent: 300 m}\nstages: {pit: {use: source/synthetic_pit}}\n");
  write("a.yaml", "include: common.yaml\n");
  write("b.yaml", "include: common.yaml\noutputs: {t.tum: pit}\n");
  const Checked checked = check_file(write("main.yaml", "stope: 1\ninclude: [a.yaml, b.yaml]\n"));
  ASSERT_TRUE(checked.plan) << checked.text;
  EXPECT_EQ(checked.plan->files_read.size(), 4U);
}

TEST_F(Files, TheIncludingFileSettlesAConflict) {
  write("a.yaml", "vars: {extent: 300 m}\n");
  write("b.yaml", "vars: {extent: 400 m}\n");
  const std::string rest =
      "stages: {pit: {use: source/synthetic_pit, params: {extent: \"${extent}\"}}}\n"
      "outputs: {t.tum: pit}\n";
  EXPECT_FALSE(check_file(write("main.yaml", "stope: 1\ninclude: [a.yaml, b.yaml]\n" + rest)).plan);
  const Checked checked = check_file(
      write("main.yaml", "stope: 1\ninclude: [a.yaml, b.yaml]\nvars: {extent: 500 m}\n" + rest));
  ASSERT_TRUE(checked.plan) << checked.text;
  EXPECT_EQ(std::get<double>(checked.parameter("pit", "extent")), 500.0);
}

TEST_F(Files, APathIsRelativeToTheFileThatWritesIt) {
  write("maps/mine.yaml", "");
  write("maps/other.yaml", "");
  write("deep/maps/mine.yaml", "");
  write("deep/vars.yaml", "vars: {map: maps/mine.yaml, folder: maps}\n");
  const auto path_of = [&](const std::string& params, const std::vector<std::string>& set = {}) {
    const Checked checked = check_file(write("main.yaml",
                                             "stope: 1\ninclude: deep/vars.yaml\nstages:\n"
                                             "  map: {use: map_source/map_server, params: {map: " +
                                                 params + "}}\n"),
                                       set);
    EXPECT_TRUE(checked.plan) << checked.text;
    return checked.plan ? std::get<std::string>(checked.parameter("map", "map")) : "";
  };
  const std::string root = folder_.string();
  EXPECT_EQ(path_of("maps/mine.yaml"), root + "/maps/mine.yaml");
  EXPECT_EQ(path_of("./deep/../maps/mine.yaml"), root + "/maps/mine.yaml");
  // A variable's path belongs to the file that wrote the variable…
  EXPECT_EQ(path_of("\"${map}\""), root + "/deep/maps/mine.yaml");
  EXPECT_EQ(path_of("\"${folder}/mine.yaml\""), root + "/deep/maps/mine.yaml");
  // … and that of --set to the working directory.
  std::filesystem::current_path(folder_ / "maps");
  EXPECT_EQ(path_of("\"${map}\"", {"vars.map=other.yaml"}), root + "/maps/other.yaml");
  EXPECT_EQ(path_of("\"${map}\"", {"map.map=other.yaml"}), root + "/maps/other.yaml");
  EXPECT_EQ(path_of("\"${map}\"", {"vars.map=" + root + "/maps/mine.yaml"}),
            root + "/maps/mine.yaml");
}

TEST_F(Files, AHugeFileIsRefusedUnread) {
  const Checked checked = check_file(write("main.yaml", "stope: 1\n" + std::string(2 << 20, '#')));
  EXPECT_FALSE(checked.plan);
  ASSERT_EQ(checked.diagnostics.size(), 1U);
  EXPECT_EQ(checked.diagnostics[0].code, "P002");
}

TEST_F(Files, WhatCannotBeReadIsSaid) {
  EXPECT_NE(check_file((folder_ / "nothing.yaml").string()).text.find("does not exist"),
            std::string::npos);
  EXPECT_NE(check_file(folder_.string()).text.find("is a folder"), std::string::npos);
}

}  // namespace
}  // namespace stope
