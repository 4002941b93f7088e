// What the stage refuses, and what a picture's pixels are; that all comes back is tested beside the
// reader (tests/plugins/map_source/conical_map_test.cpp).
#include <gtest/gtest.h>

#include "tests/plugins/export/export_samples.hpp"
#include "tests/plugins/stage_harness.hpp"

extern "C" const stope::StageEntry* stope_stage_ConicalMap();

namespace stope::exports {
namespace {

using stope::testing::StageHarness;

/// Two regions side by side, four cells each, over a column of no region.
RegionMap two_regions() {
  RegionMap map;
  map.labels.frame = {5, 2, 0.5, {1, 2, 0}};
  map.labels.cells.dense() = {1, 1, 2, 2, 0, 1, 1, 2, 2, 0};
  map.regions = {{7, 1.5, 2.5, 0.5, 0.5, 0, 1.0}, {9, 2.5, 2.5, 0.5, 0.5, 0, 1.0}};
  map.adjacency = {0, 1};
  return map;
}

std::string error_of(const RegionMap& map) {
  return stope::testing::error_of(
      [&] { StageHarness(stope_stage_ConicalMap()).input("regions", map).apply<Artefact>(); });
}

TEST(ConicalMapExport, PaintsByThePapersFormulas) {
  OccupancyGrid grid;
  grid.frame = two_regions().labels.frame;
  grid.cells = {0, 254, 0, 255, 254, 127, 0, 254, 0, 255};
  const Artefact artefact = StageHarness(stope_stage_ConicalMap())
                                .input("regions", two_regions())
                                .input("grid", grid)
                                .set("stem", "rooms")
                                .set("floor", 0.4)
                                .apply<Artefact>();
  ASSERT_EQ(artefact.files.at(0).extension, "ppm");
  const std::string ppm = text_of(artefact, "ppm");
  ASSERT_EQ(ppm.size(), std::string("P6\n5 2\n255\n").size() + 30);
  const auto pixel = [&](std::size_t i) {
    const auto* at = reinterpret_cast<const std::uint8_t*>(ppm.data()) + ppm.size() - 30 + 3 * i;
    return std::array<int, 3>{at[0], at[1], at[2]};
  };
  using Rgb = std::array<int, 3>;
  // The picture's second row is the grid's first: free at OM = 0.4, occupied at 1, unknown dark.
  // One region is red; the other lies opposite, cyan.
  const Rgb red = pixel(5);
  EXPECT_TRUE(red == (Rgb{255, 153, 153}) || red == (Rgb{153, 255, 255}));
  const bool first_is_red = red[0] == 255;
  EXPECT_EQ(pixel(first_is_red ? 5 : 7), (Rgb{255, 153, 153}));
  EXPECT_EQ(pixel(first_is_red ? 7 : 5), (Rgb{153, 255, 255}));
  EXPECT_EQ(pixel(6), first_is_red ? (Rgb{255, 0, 0}) : (Rgb{0, 255, 255}));
  EXPECT_EQ(pixel(9), (Rgb{0, 0, 0}));        // a wall of no region
  EXPECT_EQ(pixel(4), (Rgb{205, 205, 205}));  // unknown, of no region
  const std::string yaml = text_of(artefact, "yaml");
  for (const char* line :
       {"image: \"rooms.ppm\"", "resolution: 0.5", "origin: [1, 2, 0]", "mode: scale",
        "vertices: 2", "{vertex: 0, pixel: [1, 0], adjacent: [1], id: 7, centre: [1.5, 2.5]"})
    EXPECT_NE(yaml.find(line), std::string::npos) << line << "\n" << yaml;
}

TEST(ConicalMapExport, RefusesRegionsThatCouldNotBeReadBack) {
  const auto expect = [](const RegionMap& map, const char* part) {
    EXPECT_NE(error_of(map).find(part), std::string::npos) << part << ": " << error_of(map);
  };
  EXPECT_EQ(error_of(two_regions()), "");
  expect(RegionMap{}, "has no labels");
  RegionMap map = two_regions();
  map.labels.cells.dense()[3] = 3;
  expect(map, "the cell (3, 0) of the region map has the label 3, but there are 2 regions");
  map = two_regions();
  map.labels.cells.dense()[3] = -1;
  expect(map, "has the label -1");
  map = two_regions();
  map.adjacency = {0, 2};
  expect(map, "adjacent pair (0, 2) is wrong");
  map.adjacency = {1, 0};
  expect(map, "adjacent pair (1, 0) is wrong");
  map.adjacency = {0};
  expect(map, "odd length");
  map = two_regions();
  map.regions[1].id = 7;
  expect(map, "ids do not increase");
  map = two_regions();
  map.semantics = {"kitchen"};
  expect(map, "2 regions and 1 semantics");
}

TEST(ConicalMapExport, RefusesAGridThatIsNotTheRegions) {
  OccupancyGrid grid;
  grid.frame = two_regions().labels.frame;
  grid.frame.resolution = 0.25;
  grid.cells.assign(10, 0);
  const std::string sentence = stope::testing::error_of([&] {
    StageHarness(stope_stage_ConicalMap())
        .input("regions", two_regions())
        .input("grid", grid)
        .apply<Artefact>();
  });
  EXPECT_NE(sentence.find("is another than the regions were made of"), std::string::npos);
}

}  // namespace
}  // namespace stope::exports
