// Whatever bytes a map's files have, its reader gives a map or a sentence, and nothing else.
#include <gtest/gtest.h>

#include <fstream>
#include <functional>
#include <iterator>

#include "plugins/export/conical_files.hpp"
#include "tests/plugins/damaged_bytes.hpp"
#include "tests/plugins/map_source/map_files.hpp"
#include "tests/plugins/stage_harness.hpp"

extern "C" const stope::StageEntry* stope_stage_ConicalMap();
extern "C" const stope::StageEntry* stope_stage_MapServer();
extern "C" const stope::StageEntry* stope_stage_Movingai();

namespace stope::map_source {
namespace {

using stope::testing::damaged;
using stope::testing::damaged_files;
using stope::testing::StageHarness;

/// A grid that a reader gives holds as many cells as it says, and lies somewhere.
void expect_sound(const OccupancyGrid& grid) {
  EXPECT_EQ(grid.cells.size(), grid.frame.size());
  EXPECT_GT(grid.frame.width, 0);
  EXPECT_GT(grid.frame.height, 0);
  EXPECT_GT(grid.frame.resolution, 0);
}

/// Reads until something is found; sentences must name the file.
void read_or_say(const std::string& folder, const std::function<void()>& read, int& refused) {
  const std::string said = stope::testing::error_of(read);
  if (said.empty()) return;
  ++refused;
  EXPECT_NE(said.find(folder), std::string::npos) << said;
  EXPECT_LT(said.size(), 600U) << said;
}

void read_grid(const StageEntry* entry, const std::filesystem::path& map) {
  StageHarness stage(entry);
  stope::testing::MemoryOutput<OccupancyGrid> grid;
  stage.set("map", map.string()).connect_output("grid", grid).run();
  expect_sound(*grid.items.at(0).value);
}

TEST(DamagedFiles, MovingAiMaps) {
  const MapFolder folder;
  const std::string sound = "type octile\nheight 4\nwidth 6\nmap\n.GS@..\nOTW.@@\n......\n@....@\n";
  Random random(1);
  int refused = 0;
  for (int i = 0; i < damaged_files(1500); ++i) {
    const auto file = folder.write("a.map", damaged(sound, random));
    read_or_say(
        folder.path().string(), [&] { read_grid(stope_stage_Movingai(), file); }, refused);
  }
  EXPECT_GT(refused, 0);
}

TEST(DamagedFiles, MapServerYamls) {
  const MapFolder folder;
  folder.write("a.pgm", std::string("P5\n3 2\n255\n") + std::string("\0\xfe\xcd\xff\x10\x80", 6));
  const std::string sound =
      "image: a.pgm\nresolution: 0.05\norigin: [-1.5, 2, 0.1]\nnegate: 0\noccupied_thresh: 0.65\n"
      "free_thresh: 0.196\nmode: scale\n";
  Random random(2);
  int refused = 0;
  for (int i = 0; i < damaged_files(1500); ++i) {
    const auto file = folder.write("a.yaml", damaged(sound, random));
    read_or_say(
        folder.path().string(), [&] { read_grid(stope_stage_MapServer(), file); }, refused);
  }
  EXPECT_GT(refused, 0);
}

TEST(DamagedFiles, PicturesOfEveryKind) {
  const MapFolder folder;
  std::vector<std::uint8_t> samples;
  for (int i = 0; i < 12 * 9 * 4; ++i) samples.push_back(static_cast<std::uint8_t>(37 * i));
  folder.write_png("grey.png", 12, 9, 8, 0, samples);
  folder.write_png("colour.png", 12, 9, 8, 6, samples, true);
  const auto bytes_of = [&](const char* name) {
    std::ifstream stream(folder.path() / name, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(stream), {});
  };
  const std::string grey(reinterpret_cast<const char*>(samples.data()), 12 * 9 * 3);
  const auto yaml = folder.write_yaml("a.picture");
  Random random(3);
  int refused = 0;
  for (const std::string& sound :
       {bytes_of("grey.png"), bytes_of("colour.png"), "P5\n# from a scan\n12 9\n255\n" + grey,
        "P6 12 9 255\n" + grey, "P5 6 9 65535\n" + grey,
        std::string("P2\n3 2\n15\n1 2 3\n15 0 7\n"), std::string("P3 1 2 9 1 2 3 4 5 6")}) {
    for (int i = 0; i < damaged_files(600); ++i) {
      folder.write("a.picture", damaged(sound, random));
      read_or_say(
          folder.path().string(), [&] { read_grid(stope_stage_MapServer(), yaml); }, refused);
    }
  }
  EXPECT_GT(refused, 0);
}

/// Two rooms of 6 x 8 cells with a wall between them, as Stope writes them and as the paper does.
std::pair<std::string, std::string> written_conical() {
  RegionMap map;
  map.labels.frame = {13, 8, 0.1, {-1, 2, 0}};
  OccupancyGrid grid;
  grid.frame = map.labels.frame;
  for (int i = 0; i < 13 * 8; ++i) {
    map.labels.cells.dense().push_back(i % 13 < 6 ? 1 : i % 13 > 6 ? 2 : 0);
    grid.cells.push_back(i % 13 == 6 ? OccupancyGrid::kOccupied
                                     : static_cast<std::uint8_t>(i % 3 * 20));
  }
  for (const std::uint64_t id : {7U, 9U})
    map.regions.push_back({id, 0.5 * static_cast<double>(id), 1, 0.4, 0.3, 0.1, 0.48});
  map.adjacency = {0, 1};
  map.semantics = {"store", "hall"};
  stope::testing::MemoryContext context;
  const Artefact artefact = exports::conical_files(map, &grid, {"map", 0.35}, context);
  const auto text = [&](std::size_t i) {
    return std::string(artefact.files.at(i).bytes.begin(), artefact.files.at(i).bytes.end());
  };
  return {text(0), text(1)};
}

const std::string kByThePaper =
    "image: map.ppm\nresolution: 0.2\norigin: [0, 0, 0]\nfree_thresh: 0.2\noccupied_thresh: 0.65\n"
    "hue_step: 20\nvertices: 2\ntopology:\n  - {vertex: 0, pixel: [1, 1], adjacent: [1]}\n"
    "  - {vertex: 1, pixel: [5, 2], adjacent: [0], semantics: hall}\n";

TEST(DamagedFiles, ConicalMaps) {
  const MapFolder folder;
  const auto [ppm, yaml] = written_conical();
  Random random(4);
  int refused = 0;
  const auto read = [&] {
    StageHarness stage(stope_stage_ConicalMap());
    stope::testing::MemoryOutput<OccupancyGrid> grid;
    stope::testing::MemoryOutput<RegionMap> regions;
    stage.set("map", (folder.path() / "map.yaml").string())
        .connect_output("grid", grid)
        .connect_output("regions", regions)
        .run();
    expect_sound(*grid.items.at(0).value);
    const RegionMap& map = *regions.items.at(0).value;
    EXPECT_EQ(map.labels.cells.size(), grid.items.at(0).value->cells.size());
    for (const std::int32_t label : map.labels.cells.to_vector()) {
      ASSERT_GE(label, 0);
      ASSERT_LE(static_cast<std::size_t>(label), map.regions.size());
    }
    for (const std::uint32_t place : map.adjacency) ASSERT_LT(place, map.regions.size());
    for (std::size_t i = 1; i < map.regions.size(); ++i)
      ASSERT_LT(map.regions[i - 1].id, map.regions[i].id);
  };
  for (const std::string& sound : {yaml, kByThePaper}) {
    for (int i = 0; i < damaged_files(1500); ++i) {
      const bool picture = random.below(3) == 0;
      folder.write("map.ppm", picture ? damaged(ppm, random) : ppm);
      folder.write("map.yaml", picture ? sound : damaged(sound, random));
      read_or_say(folder.path().string(), read, refused);
    }
  }
  EXPECT_GT(refused, 0);
}

}  // namespace
}  // namespace stope::map_source
