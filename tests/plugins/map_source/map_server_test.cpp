#include <gtest/gtest.h>
#include <png.h>

#include <algorithm>
#include <cstdlib>

#include "tests/plugins/map_source/map_files.hpp"
#include "tests/plugins/stage_harness.hpp"

extern "C" const stope::StageEntry* stope_stage_MapServer();

namespace stope::map_source {
namespace {

using Cells = std::vector<std::uint8_t>;
constexpr std::uint8_t kF = 0, kO = 254, kU = 255;

OccupancyGrid read(const std::filesystem::path& yaml,
                   std::vector<std::string>* sentences = nullptr) {
  stope::testing::StageHarness stage(stope_stage_MapServer());
  stope::testing::MemoryOutput<OccupancyGrid> grid;
  stage.set("map", yaml.string()).connect_output("grid", grid).run();
  if (sentences) *sentences = stage.context().sentences;
  return *grid.items.at(0).value;
}

std::string error_of(const std::filesystem::path& yaml) {
  return stope::testing::error_of([&] { read(yaml); });
}

TEST(MapServer, TheTopRowOfThePictureIsTheHighestOfTheGrid) {
  const MapFolder folder;
  folder.write("a.pgm", std::string("P5\n# a comment\n3 2\n255\n\xfe\xfe\x00\xcd\x00\xfe", 29));
  const OccupancyGrid grid = read(folder.write_yaml("a.pgm"));
  EXPECT_EQ(grid.frame.width, 3);
  EXPECT_EQ(grid.frame.height, 2);
  EXPECT_EQ(grid.frame.resolution, 0.5);
  EXPECT_EQ(grid.frame.origin, (Pose2{10, 20, 0.25}));
  EXPECT_EQ(grid.cells, (Cells{kU, kO, kF, kF, kF, kO}));
}

TEST(MapServer, AlsoReadsThePictureItsYamlNames) {
  const MapFolder folder;
  stope::testing::StageHarness stage(stope_stage_MapServer());
  EXPECT_TRUE(stage.info().also_reads);
  stage.set("map", folder.write_yaml("not-there.pgm").string());
  EXPECT_EQ(stage.also_reads(),
            (std::vector<std::filesystem::path>{folder.path() / "not-there.pgm"}));
  stage.set("map", (folder.path() / "no.yaml").string());
  EXPECT_THROW(stage.also_reads(), Error);
}

TEST(MapServer, ReadsPlainAndWidePgm) {
  const MapFolder folder;
  folder.write("plain.pgm", "P2 2 2 # size\n15\n15 0\n0 15\n");
  EXPECT_EQ(read(folder.write_yaml("plain.pgm")).cells, (Cells{kO, kF, kF, kO}));
  folder.write("wide.pgm", std::string("P5 2 1 65535\n\xff\xff\x00\x01", 17));
  EXPECT_EQ(read(folder.write_yaml("wide.pgm")).cells, (Cells{kF, kO}));
}

TEST(MapServer, ReadsEveryKindOfPng) {
  const MapFolder folder;
  const Cells expected{kF, kO, kU};  // one row: white, black, 205
  folder.write_png("g8.png", 3, 1, 8, PNG_COLOR_TYPE_GRAY, {255, 0, 205});
  folder.write_png("g16.png", 3, 1, 16, PNG_COLOR_TYPE_GRAY, {255, 255, 0, 0, 205, 205});
  folder.write_png("rgb.png", 3, 1, 8, PNG_COLOR_TYPE_RGB, {255, 255, 255, 0, 0, 0, 205, 205, 205});
  folder.write_png("palette.png", 3, 1, 8, PNG_COLOR_TYPE_PALETTE, {1, 0, 2});
  folder.write_png("palette2.png", 3, 1, 2, PNG_COLOR_TYPE_PALETTE, {1, 0, 2});
  for (const char* name : {"g8.png", "g16.png", "rgb.png", "palette.png", "palette2.png"}) {
    EXPECT_EQ(read(folder.write_yaml(name)).cells, expected) << name;
  }
  folder.write_png("bits.png", 3, 1, 1, PNG_COLOR_TYPE_GRAY, {1, 0, 1});
  EXPECT_EQ(read(folder.write_yaml("bits.png")).cells, (Cells{kF, kO, kF}));
}

TEST(MapServer, AlphaIsAveragedInTrinaryAndUnknownInScale) {
  const MapFolder folder;
  // Opaque black: (0 + 0 + 0 + 255) / 4 leaves 0.25 of brightness, occupied; transparent white
  // 0.75, unknown.
  folder.write_png("a.png", 2, 1, 8, PNG_COLOR_TYPE_RGB_ALPHA, {0, 0, 0, 255, 255, 255, 255, 0});
  EXPECT_EQ(read(folder.write_yaml("a.png")).cells, (Cells{kO, kU}));
  EXPECT_EQ(read(folder.write_yaml("a.png", "mode: scale\n")).cells, (Cells{kO, kU}));
  folder.write_png("ga.png", 2, 1, 8, PNG_COLOR_TYPE_GRAY_ALPHA, {255, 255, 255, 128});
  EXPECT_EQ(read(folder.write_yaml("ga.png", "mode: scale\n")).cells, (Cells{kF, kU}));
}

TEST(MapServer, AnInterlacedPngReadsAsAPlainOne) {
  const MapFolder folder;
  Cells samples(19 * 13);
  for (std::size_t i = 0; i < samples.size(); ++i)
    samples[i] = static_cast<std::uint8_t>(i * 37 % 256);
  folder.write_png("plain.png", 19, 13, 8, PNG_COLOR_TYPE_GRAY, samples);
  const auto plain = read(folder.write_yaml("plain.png", "mode: scale\n"));
  folder.write_png("inter.png", 19, 13, 8, PNG_COLOR_TYPE_GRAY, samples, true);
  EXPECT_EQ(read(folder.write_yaml("inter.png", "mode: scale\n")).cells, plain.cells);
}

TEST(MapServer, WarnsOfAMapWithoutFreeCells) {
  const MapFolder folder;
  folder.write("a.pgm", "P2 2 1 255 0 0");
  std::vector<std::string> sentences;
  EXPECT_EQ(read(folder.write_yaml("a.pgm"), &sentences).cells, (Cells{kO, kO}));
  EXPECT_NE(sentences.at(0).find("no cell of the map"), std::string::npos);
}

TEST(MapServer, SaysWhatIsWrongWithAPicture) {
  const MapFolder folder;
  EXPECT_NE(error_of(folder.write_yaml("gone.png")).find("gone.png does not exist"),
            std::string::npos);
  folder.write("empty.png", "");
  EXPECT_NE(error_of(folder.write_yaml("empty.png")).find("is empty"), std::string::npos);
  folder.write("text.png", "hello");
  EXPECT_NE(error_of(folder.write_yaml("text.png")).find("neither PNG nor PGM"), std::string::npos);
  folder.write("short.pgm", "P5 100 100 255\nxx");
  EXPECT_NE(error_of(folder.write_yaml("short.pgm")).find("is cut off"), std::string::npos);
  folder.write("odd.pgm", "P5 0 100 255\nxx");
  EXPECT_NE(error_of(folder.write_yaml("odd.pgm")).find("no width"), std::string::npos);
  folder.write("words.pgm", "P2 2 2 255\n1 two 3 4");
  EXPECT_NE(error_of(folder.write_yaml("words.pgm")).find("not a number"), std::string::npos);
}

TEST(MapServer, ATruncatedPngIsNamedAtEveryLength) {
  const MapFolder folder;
  Cells noise(64 * 64);
  Random random(1);
  for (auto& sample : noise) sample = static_cast<std::uint8_t>(random.below(256));
  const auto file = folder.write_png("a.png", 64, 64, 8, PNG_COLOR_TYPE_GRAY, noise);
  const auto yaml = folder.write_yaml("a.png");
  ASSERT_EQ(error_of(yaml), "");
  for (const std::uintmax_t length : {3000U, 500U, 60U, 40U, 20U, 8U}) {
    std::filesystem::resize_file(file, length);
    EXPECT_NE(error_of(yaml).find("a.png"), std::string::npos) << length;
  }
}

TEST(MapServer, SaysWhatIsWrongWithTheYaml) {
  const MapFolder folder;
  folder.write("a.pgm", "P2 1 1 255 255");
  const std::vector<std::string> lines{"image: a.pgm", "resolution: 0.5",       "origin: [0, 0, 0]",
                                       "negate: 0",    "occupied_thresh: 0.65", "free_thresh: 0.2"};
  for (std::size_t left_out = 0; left_out < lines.size(); ++left_out) {
    std::string text;
    for (std::size_t i = 0; i < lines.size(); ++i) text += i == left_out ? "" : lines[i] + "\n";
    const std::string key = lines[left_out].substr(0, lines[left_out].find(':'));
    EXPECT_NE(error_of(folder.write("m.yaml", text)).find("does not say '" + key + "'"),
              std::string::npos)
        << key;
  }
  const auto with = [&](std::size_t place, const std::string& line) {
    std::string text;
    for (std::size_t i = 0; i < lines.size(); ++i) text += (i == place ? line : lines[i]) + "\n";
    return error_of(folder.write("m.yaml", text));
  };
  EXPECT_NE(with(1, "resolution: -1").find("m.yaml:2: 'resolution' is wrong"), std::string::npos);
  EXPECT_NE(with(1, "resolution: fine").find("'resolution' is wrong"), std::string::npos);
  EXPECT_NE(with(2, "origin: [0, 0]").find("m.yaml:3: 'origin' is wrong"), std::string::npos);
  EXPECT_NE(with(2, "origin: [0, .nan, 0]").find("'origin' is wrong"), std::string::npos);
  EXPECT_NE(with(2, "origin: [0, 1e300, 0]").find("'origin' is wrong"), std::string::npos);
  EXPECT_NE(with(2, "origin: [0, 0, 0]\nresolution: 0.6")
                .find("m.yaml:4: 'resolution' is given twice, first in line 2"),
            std::string::npos);
  EXPECT_NE(with(3, "negate: maybe").find("'negate' is wrong"), std::string::npos);
  EXPECT_NE(with(4, "occupied_thresh: 0.1").find("'occupied_thresh' is wrong"), std::string::npos);
  EXPECT_NE(with(5, "free_thresh: -0.1").find("'free_thresh' is wrong"), std::string::npos);
  EXPECT_NE(with(0, "image: a.pgm\nmode: ternary").find("'mode' is wrong"), std::string::npos);
  EXPECT_NE(with(0, "image: [").find("this is not YAML"), std::string::npos);
  EXPECT_EQ(with(3, "negate: false"), "");
}

TEST(MapServer, ReadsTheRealMine) {
  const char* data = std::getenv("STOPE_DATA");
  const std::filesystem::path folder =
      (data ? std::filesystem::path(data)
            : std::filesystem::path(STOPE_SOURCE_DIR) / "../shared/data") /
      "open_pit_maps";
  if (!std::filesystem::exists(folder / "dapai_0p5m.yaml"))
    GTEST_SKIP() << "STOPE_DATA has no open_pit_maps, so the real mine is not read";
  const OccupancyGrid grid = read(folder / "dapai_0p5m.yaml");
  EXPECT_EQ(grid.frame.width, 4216);
  EXPECT_EQ(grid.frame.height, 2591);
  EXPECT_EQ(std::count(grid.cells.begin(), grid.cells.end(), kU), 0);
  // A truck of the scenarios drives here.
  const auto cell = grid.frame.cell_at(1644.0, 960.0);
  ASSERT_TRUE(cell);
  EXPECT_GT(std::count(grid.cells.begin(), grid.cells.end(), kF), 100000);
}

}  // namespace
}  // namespace stope::map_source
