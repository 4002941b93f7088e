// What export/conical_map writes, read back; and maps by the paper's own formulas.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>

#include "plugins/export/conical_files.hpp"
#include "stope/digest.hpp"
#include "tests/plugins/map_source/map_files.hpp"
#include "tests/plugins/stage_harness.hpp"

extern "C" const stope::StageEntry* stope_stage_ConicalMap();

namespace stope::map_source {
namespace {

struct Read {
  OccupancyGrid grid;
  RegionMap regions;
  std::vector<std::string> sentences;
};

Read read(const std::filesystem::path& yaml) {
  stope::testing::StageHarness stage(stope_stage_ConicalMap());
  stope::testing::MemoryOutput<OccupancyGrid> grid;
  stope::testing::MemoryOutput<RegionMap> regions;
  stage.set("map", yaml.string())
      .connect_output("grid", grid)
      .connect_output("regions", regions)
      .run();
  return {*grid.items.at(0).value, *regions.items.at(0).value, stage.context().sentences};
}

std::string error_of(const std::filesystem::path& yaml) {
  return stope::testing::error_of([&] { read(yaml); });
}

struct Files {
  std::string ppm, yaml;
};

Files files_of(const RegionMap& regions, const OccupancyGrid* grid, double floor = 0.35) {
  stope::testing::MemoryContext context;
  const Artefact artefact = exports::conical_files(regions, grid, {"map", floor}, context);
  const auto text = [&](std::size_t i) {
    return std::string(artefact.files.at(i).bytes.begin(), artefact.files.at(i).bytes.end());
  };
  return {text(0), text(1)};
}

std::filesystem::path write(const MapFolder& folder, const Files& files) {
  folder.write("map.ppm", files.ppm);
  return folder.write("map.yaml", files.yaml);
}

/// Regions grown from random seeds, each cell to its nearest; some cells have none.
RegionMap made_regions(std::uint64_t seed, int width, int height, int count) {
  Random random(seed);
  RegionMap map;
  map.labels.frame = {width, height, 0.05, {-12.625, 1.0 / 3, 0.1}};
  std::vector<std::pair<double, double>> seeds;
  for (int i = 0; i < count; ++i) {
    seeds.emplace_back(random.uniform(0, width), random.uniform(0, height));
    Region region;
    region.id = 10 * static_cast<std::uint64_t>(i) + 1 + random.below(9);
    region.x = random.normal() * 30, region.y = random.normal() * 30;
    region.major = random.uniform(), region.minor = random.uniform() / 3;
    region.yaw = random.uniform(-3.2, 3.2);
    region.area = random.uniform(0, 100);
    map.regions.push_back(region);
  }
  for (std::uint32_t i = 0; i + 3 < static_cast<std::uint32_t>(count); i += 2)
    map.adjacency.insert(map.adjacency.end(), {i, i + 1, i, i + 3});
  map.labels.cells.dense().assign(map.labels.frame.size(), 0);
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      if (random.below(12) == 0) continue;
      double nearest = 1e300;
      int label = 0;
      for (int i = 0; i < count; ++i) {
        const auto& [x, y] = seeds[static_cast<std::size_t>(i)];
        const double distance = std::hypot(x - column, y - row);
        if (distance < nearest) nearest = distance, label = i + 1;
      }
      map.labels.cells.dense()[map.labels.frame.place({column, row})] = label;
    }
  }
  return map;
}

OccupancyGrid made_grid(const RegionMap& map, std::uint64_t seed) {
  Random random(seed);
  OccupancyGrid grid;
  grid.frame = map.labels.frame;
  for (std::size_t i = 0; i < grid.frame.size(); ++i)
    grid.cells.push_back(static_cast<std::uint8_t>(random.below(256)));
  return grid;
}

void expect_back(const RegionMap& map, const OccupancyGrid& grid, const Files& files) {
  const MapFolder folder;
  const Read back = read(write(folder, files));
  EXPECT_EQ(digest_of(back.regions), digest_of(map));
  EXPECT_EQ(digest_of(back.grid), digest_of(grid));
}

TEST(ConicalMap, RegionsAndEveryValueOfOccupancyComeBackToTheLastBit) {
  for (std::uint64_t seed = 1; seed <= 8; ++seed) {
    RegionMap map = made_regions(seed, 70, 50, 25);
    const OccupancyGrid grid = made_grid(map, seed);
    if (seed % 2 == 0) {
      for (std::size_t i = 0; i < map.regions.size(); ++i)
        map.semantics.push_back(i % 3 == 0 ? "" : "room \"" + std::to_string(i) + "\": a\\b\n#");
      map.labels.names = {"", "kitchen", "~"};
    }
    map.regions[3].area = std::numeric_limits<double>::infinity();
    map.regions[4].yaw = -0.0;
    map.regions[5].x = std::numeric_limits<double>::quiet_NaN();
    for (const double floor : {0.0118, 0.35, 0.5})
      expect_back(map, grid, files_of(map, &grid, floor));
  }
}

TEST(ConicalMap, AlsoReadsThePictureItsYamlNamesOrTheOneBesideIt) {
  const MapFolder folder;
  const RegionMap map = made_regions(1, 12, 9, 4);
  const Files files = files_of(map, nullptr);
  stope::testing::StageHarness stage(stope_stage_ConicalMap());
  stage.set("map", write(folder, files).string());
  EXPECT_EQ(stage.also_reads(), (std::vector<std::filesystem::path>{folder.path() / "map.ppm"}));
  folder.write("renamed.ppm", files.ppm);
  stage.set("map", folder.write("renamed.yaml", files.yaml).string());
  EXPECT_EQ(stage.also_reads(), (std::vector<std::filesystem::path>{folder.path() / "map.ppm"}));
  std::filesystem::remove(folder.path() / "map.ppm");
  EXPECT_EQ(stage.also_reads(),
            (std::vector<std::filesystem::path>{folder.path() / "renamed.ppm"}));
}

TEST(ConicalMap, ARegionWithoutCellsAndOneOfManyPiecesComeBack) {
  RegionMap map = made_regions(4, 40, 30, 6);
  for (std::int32_t& label : map.labels.cells.dense()) {
    if (label == 2) label = 0;
  }
  for (int column = 0; column < 40; column += 4)
    map.labels.cells.dense()[map.labels.frame.place({column, 29})] = 5;
  OccupancyGrid grid = made_grid(map, 1);
  expect_back(map, grid, files_of(map, &grid));
}

// Each region in hundreds of pieces that touch all others: no colouring of regions with few hues.
TEST(ConicalMap, NoiseComesBack) {
  Random random(9);
  RegionMap map = made_regions(9, 90, 80, 200);
  for (std::int32_t& label : map.labels.cells.dense())
    label = static_cast<std::int32_t>(random.below(201));
  OccupancyGrid grid = made_grid(map, 2);
  expect_back(map, grid, files_of(map, &grid));
}

TEST(ConicalMap, TwelveThousandRegionsComeBackInThreeTimesThePlainMap) {
  // 120 x 100 rooms of 8 x 8 cells with walls between, each fifth one in two pieces.
  RegionMap map;
  map.labels.frame = {120 * 9, 100 * 9, 0.05, {}};
  map.labels.cells.dense().assign(map.labels.frame.size(), 0);
  OccupancyGrid grid;
  grid.frame = map.labels.frame;
  grid.cells.assign(grid.frame.size(), OccupancyGrid::kFree);
  for (std::uint32_t i = 0; i < 12000; ++i) {
    const auto column = static_cast<std::int32_t>(i % 120),
               row = static_cast<std::int32_t>(i / 120);
    map.regions.push_back({i + 1, column * 0.45 + 0.2, row * 0.45 + 0.2, 0.2, 0.1, 0.5, 0.16});
    if (column > 0) map.adjacency.insert(map.adjacency.end(), {i - 1, i});
    for (std::int32_t y = 0; y < 9; ++y) {
      for (std::int32_t x = 0; x < 9; ++x) {
        const std::size_t place = map.labels.frame.place({column * 9 + x, row * 9 + y});
        const bool wall = y == 8 || (x == 8 && y % 2 == 0) || (i % 5 == 0 && x == 4);
        if (wall)
          grid.cells[place] = y % 3 == 0 ? OccupancyGrid::kUnknown : OccupancyGrid::kOccupied;
        map.labels.cells.dense()[place] = wall ? 0 : static_cast<std::int32_t>(i) + 1;
      }
    }
  }
  const Files files = files_of(map, &grid);
  expect_back(map, grid, files);
  const auto pgm = static_cast<double>(grid.frame.size() + 16);
  EXPECT_LE(static_cast<double>(files.ppm.size()), 3.05 * pgm);
}

double hue_of(const std::uint8_t* rgb) {
  const double r = rgb[0], g = rgb[1], b = rgb[2];
  const double top = std::max({r, g, b}), least = std::min({r, g, b});
  if (top == least) return -1;
  const double hue = top == r   ? 60 * (g - b) / (top - least)
                     : top == g ? 120 + 60 * (b - r) / (top - least)
                                : 240 + 60 * (r - g) / (top - least);
  return hue < 0 ? hue + 360 : hue;
}

TEST(ConicalMap, RegionsThatTouchDifferInHue) {
  const RegionMap map = made_regions(6, 80, 60, 40);
  const Files files = files_of(map, nullptr);
  const GridFrame& frame = map.labels.frame;
  const auto* pixels =
      reinterpret_cast<const std::uint8_t*>(files.ppm.data()) + files.ppm.size() - 3 * frame.size();
  const auto hue_at = [&](Cell cell) {
    return hue_of(pixels + 3 * frame.place({cell.column, frame.height - 1 - cell.row}));
  };
  std::set<int> hues;
  for (int row = 0; row + 1 < frame.height; ++row) {
    for (int column = 1; column + 1 < frame.width; ++column) {
      const std::int32_t label = map.labels.cells[frame.place({column, row})];
      if (label == 0) continue;
      hues.insert(static_cast<int>(std::lround(hue_at({column, row}))));
      for (const Cell next : {Cell{column + 1, row}, Cell{column - 1, row + 1},
                              Cell{column, row + 1}, Cell{column + 1, row + 1}}) {
        const std::int32_t other = map.labels.cells[frame.place(next)];
        if (other == 0 || other == label) continue;
        const double apart = std::abs(hue_at({column, row}) - hue_at(next));
        EXPECT_GE(std::min(apart, 360 - apart), 59.0) << column << ", " << row;
      }
    }
  }
  EXPECT_LE(hues.size(), 6U);
}

TEST(ConicalMap, WithoutAGridRegionsAreFreeAndTheRestIsUnknownAndItSaysSo) {
  const RegionMap map = made_regions(5, 30, 20, 4);
  const MapFolder folder;
  const Read back = read(write(folder, files_of(map, nullptr)));
  EXPECT_EQ(digest_of(back.regions), digest_of(map));
  for (std::size_t i = 0; i < map.labels.cells.size(); ++i)
    EXPECT_EQ(back.grid.cells[i],
              map.labels.cells[i] == 0 ? OccupancyGrid::kUnknown : OccupancyGrid::kFree);
  EXPECT_NE(back.sentences.at(0).find("written without a grid"), std::string::npos);
}

TEST(ConicalMap, AnOutputOfAnotherNameFindsItsPicture) {
  const RegionMap map = made_regions(5, 30, 20, 4);
  const Files files = files_of(map, nullptr);
  const MapFolder folder;
  folder.write("rooms.ppm", files.ppm);
  EXPECT_EQ(digest_of(read(folder.write("rooms.yaml", files.yaml)).regions), digest_of(map));
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t place = text.find(from);
  if (place == std::string::npos) ADD_FAILURE() << "no " << from << " in the text";
  return place == std::string::npos ? text : text.replace(place, from.size(), to);
}

TEST(ConicalMap, PictureAndYamlThatDisagreeAreNamed) {
  const RegionMap map = made_regions(2, 40, 30, 6);
  const OccupancyGrid grid = made_grid(map, 3);
  const Files good = files_of(map, &grid);
  const MapFolder folder;
  const auto error = [&](const std::string& from, const std::string& to) {
    return error_of(write(folder, {good.ppm, replaced(good.yaml, from, to)}));
  };
  const auto expect = [&](const std::string& from, const std::string& to, const char* part) {
    const std::string sentence = error(from, to);
    EXPECT_NE(sentence.find(part), std::string::npos) << from << " -> " << to << ": " << sentence;
    EXPECT_NE(sentence.find("map.yaml"), std::string::npos) << sentence;
  };
  EXPECT_EQ(error("image", "image"), "");
  expect("size: [40, 30]", "size: [30, 40]", "says 30 x 40 cells, but its picture");
  expect("vertices: 6", "vertices: 7", "'vertices' is 7, but 'topology' lists 6");
  expect("vertex: 3", "vertex: 4", "vertex 4 stands where vertex 3 belongs");
  expect("adjacent: [1, 3]", "adjacent: [1, 3, 9]", "vertex 0 is adjacent to 9");
  expect("adjacent: [1, 3]", "adjacent: [1]", "is adjacent to 0, but not the other way round");
  expect("adjacent: [1, 3]", "adjacent: [1, 3, 3]", "twice");
  expect("adjacent: [1, 3]", "adjacent: [0, 1, 3]", "vertex 0 is adjacent to 0");
  expect("pieces: \"", "pieces: \"7 ", "pieces of colour, but the picture");
  expect("cells: ", "cells: 1", "cells by the yaml");
  expect("floor: 89", "floor: 60", "'floor' is 60, with which 'free_thresh' would be");
  expect("hue_step: 60", "hue_step: 50", "has a colour at column");
  expect("hue_step: 60", "hue_step: sixty", "'hue_step' is wrong: expected a number");
  expect("version: 1", "version: 2", "the map's version is 2");
  expect("resolution: 0.05", "resolution: 0", "'resolution' is 0: expected");
  expect("topology:", "topologie:", "'topology' is missing");
  expect("image:", "image: [", "this is not YAML");

  const auto ppm_error = [&](const std::string& ppm) {
    return error_of(write(folder, {ppm, good.yaml}));
  };
  EXPECT_NE(ppm_error(good.ppm.substr(0, good.ppm.size() - 1)).find("is cut off"),
            std::string::npos);
  std::string edited = good.ppm;
  edited[edited.size() - 1] = static_cast<char>(edited[edited.size() - 1] ^ 0x55);
  EXPECT_NE(ppm_error(edited).find("column 39, row 29"), std::string::npos) << ppm_error(edited);
  // One region painted white: all of its cells are gone.
  const RegionMap other = made_regions(3, 40, 30, 6);
  const std::string sentence = ppm_error(files_of(other, &grid).ppm);
  EXPECT_TRUE(sentence.find("pieces of colour") != std::string::npos ||
              sentence.find("cells by the yaml") != std::string::npos)
      << sentence;
  EXPECT_NE(ppm_error("P5 40 30 255\n" + std::string(1200, 'x')).find("no 8-bit colour picture"),
            std::string::npos);
}

// Eqs. 6 to 8 of the paper, with V = 1, a = 0 and k = 1, in real numbers.
std::array<std::uint8_t, 3> paper_colour(double hue, double om) {
  const int h = static_cast<int>(hue / 60) % 6;
  const double f = hue / 60 - std::floor(hue / 60);
  const double p = 1 - om, q = 1 - f * om, g = 1 - (1 - f) * om;
  const double table[6][3] = {{1, g, p}, {q, 1, p}, {p, 1, g}, {p, q, 1}, {g, p, 1}, {1, p, q}};
  std::array<std::uint8_t, 3> rgb{};
  for (int i = 0; i < 3; ++i)
    rgb[static_cast<std::size_t>(i)] = static_cast<std::uint8_t>(std::lround(255 * table[h][i]));
  return rgb;
}

TEST(ConicalMap, ReadsMapsByThePapersOwnFormulas) {
  // Four rooms of 10 x 10 pixels in a row, walls (hue 0 is no vertex's) around; room 3 is wholly
  // free, so it is white. Vertex 20 has the hue of vertex 2: 20 hues are more than 18.
  constexpr int kWidth = 41, kHeight = 12;
  const int number[4] = {1, 2, 3, 20};
  const double occupied[4] = {0.1, 0.02, 0.0, 0.15};
  std::string ppm = "P6\n41 12\n255\n";
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const bool wall = y == 0 || y == kHeight - 1 || x % 10 == 0;
      const int room = std::min(x / 10, 3);
      const auto rgb =
          wall ? paper_colour(0, 1.0) : paper_colour(20 * number[room] % 360, occupied[room]);
      ppm.append(rgb.begin(), rgb.end());
    }
  }
  const MapFolder folder;
  folder.write("paper.ppm", ppm);
  const std::string head =
      "image: paper.ppm\nresolution: 0.2\norigin: [-4, -2, 0]\nfree_thresh: 0.196\n"
      "occupied_thresh: 0.65\nmode: trinary\nvertices: 4\ntopology:\n"
      "  - {vertex: 1, pixel: [5, 6], adjacent: [2]}\n"
      "  - {vertex: 2, pixel: [15, 6], adjacent: [1, 3], semantics: kitchen}\n"
      "  - {vertex: 3, pixel: [25, 6], adjacent: [2, 20]}\n";
  const Read back =
      read(folder.write("paper.yaml", head + "  - {vertex: 20, pixel: [35, 6], adjacent: [3]}\n"));
  ASSERT_EQ(back.regions.regions.size(), 4U);
  EXPECT_EQ(back.regions.adjacency, (std::vector<std::uint32_t>{0, 1, 1, 2, 2, 3}));
  EXPECT_EQ(back.regions.semantics, (std::vector<std::string>{"", "kitchen", "", ""}));
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const bool wall = y == 0 || y == kHeight - 1 || x % 10 == 0;
      const int room = std::min(x / 10, 3);
      const std::size_t place = back.grid.frame.place({x, kHeight - 1 - y});
      EXPECT_EQ(back.grid.cells[place], wall ? OccupancyGrid::kOccupied : OccupancyGrid::kFree);
      EXPECT_EQ(back.regions.labels.cells[place], wall || room == 2 ? 0 : room + 1)
          << x << ", " << y;
    }
  }
  const Region& first = back.regions.regions[0];
  EXPECT_EQ(first.id, 1U);
  EXPECT_NEAR(first.x, -4 + 5.5 * 0.2, 1e-12);
  EXPECT_NEAR(first.y, -2 + (12 - 6.5) * 0.2, 1e-12);  // eq. 9: the first row is the top
  EXPECT_NEAR(first.area, 9 * 10 * 0.04, 1e-12);
  EXPECT_NEAR(first.minor, 2 * std::sqrt((81 - 1) / 12.0) * 0.2, 1e-9);
  EXPECT_NE(back.sentences.at(0).find("1 vertices have no colour"), std::string::npos);

  EXPECT_NE(error_of(folder.write("paper.yaml", replaced(head, "vertices: 4", "vertices: 3")))
                .find("is adjacent to 20"),
            std::string::npos);
  // Without vertex 20 its cells go to the nearest vertex of their hue, and it is said.
  const Read fewer = read(folder.write(
      "paper.yaml", replaced(replaced(head, "vertices: 4", "vertices: 3"), "[2, 20]", "[2]")));
  EXPECT_EQ(fewer.regions.labels.cells[fewer.grid.frame.place({35, 6})], 2);
  EXPECT_NE(fewer.sentences.at(1).find("1 pieces of colour without a vertex"), std::string::npos);
  EXPECT_NE(error_of(folder.write("paper.yaml",
                                  head + "  - {vertex: 20, pixel: [3500, 6], adjacent: [3]}\n"))
                .find("paper.yaml:12: the pixel (3500, 6) of vertex 20 is outside"),
            std::string::npos);
  EXPECT_NE(
      error_of(folder.write("paper.yaml", replaced(head, "[5, 6]", "[15, 7]") +
                                              "  - {vertex: 20, pixel: [35, 6], adjacent: [3]}\n"))
          .find("lie in one piece of colour"),
      std::string::npos);
}

TEST(ConicalMap, AHueThatIsNoVertexsIsNamed) {
  const MapFolder folder;
  std::string ppm = "P6\n4 1\n255\n";
  for (const double hue : {20.0, 20.0, 140.0, 140.0}) {
    const auto rgb = paper_colour(hue, 0.1);
    ppm.append(rgb.begin(), rgb.end());
  }
  folder.write("paper.ppm", ppm);
  const std::string sentence = error_of(
      folder.write("paper.yaml",
                   "image: paper.ppm\nresolution: 0.2\norigin: [0, 0, 0]\nfree_thresh: 0.196\n"
                   "occupied_thresh: 0.65\nvertices: 1\ntopology:\n  - {vertex: 1, pixel: [0, 0], "
                   "adjacent: []}\n"));
  EXPECT_NE(sentence.find("hue 140 degrees from column 2, row 0"), std::string::npos) << sentence;
}

}  // namespace
}  // namespace stope::map_source
