// What one pipeline writes, another reads, and writes again: the bytes must be the same.
#include <gtest/gtest.h>

#include "small_map.hpp"
#include "stope_process.hpp"

namespace stope::testing {
namespace {

namespace fs = std::filesystem;

void run(const fs::path& folder, const std::string& name, const std::string& pipeline) {
  const fs::path file = folder / (name + ".yaml");
  write_file(file, "stope: 1\nname: " + name + "\n" + pipeline);
  const auto result = stope({"run", file.string(), "--out", (folder / name).string()});
  ASSERT_EQ(result.exit_code, 0) << result.err;
}

TEST(RoundTrip, RoadsComeBackFromNav2sRouteGraph) {
  const TemporaryFolder folder;
  const fs::path map = write_ring_map(folder.path());
  run(folder.path(), "first",
      "stages:\n  grid: {use: map_source/map_server, params: {map: " + map.string() +
          "}}\n  roads: {use: topology/voronoi, in: grid}\n"
          "outputs: {roads.geojson: roads, roads.graphml: roads}\n");
  run(folder.path(), "second",
      "stages:\n  roads: {use: road_source/nav2_route, params: {graph: "
      "first/outputs/roads.geojson}}\n"
      "outputs: {roads.geojson: roads, roads.graphml: roads}\n");
  EXPECT_EQ(output_digests(folder.path() / "first"), output_digests(folder.path() / "second"));
}

TEST(RoundTrip, RegionsComeBackFromAConicalMap) {
  const TemporaryFolder folder;
  // Two regions by the paper's own formulas, hues 20 and 40 degrees at OM = 0.2, and their yaml.
  std::string picture = "P6\n4 2\n255\n";
  for (int i = 0; i < 4; ++i) picture += "\xff\xdd\xcc\xff\xee\xcc";
  write_file(folder.path() / "paper.ppm", picture);
  write_file(folder.path() / "paper.yaml",
             "image: paper.ppm\nresolution: 0.2\norigin: [0, 0, 0]\nfree_thresh: 0.25\n"
             "occupied_thresh: 0.65\nvertices: 2\ntopology:\n"
             "  - {vertex: 1, pixel: [0, 0], adjacent: [2]}\n"
             "  - {vertex: 2, pixel: [1, 0], adjacent: [1], semantics: kitchen}\n");
  const std::string outputs =
      "outputs:\n  rooms.ppm: rooms.regions\n  exact.ppm: {use: export/conical_map, in: {regions: "
      "rooms.regions, grid: rooms.grid}, params: {stem: exact}}\n";
  run(folder.path(), "first",
      "stages:\n  rooms: {use: map_source/conical_map, params: {map: paper.yaml}}\n" + outputs);
  run(folder.path(), "second",
      "stages:\n  rooms: {use: map_source/conical_map, params: {map: first/outputs/exact.yaml}}\n" +
          outputs);
  const auto digests = output_digests(folder.path() / "first");
  EXPECT_EQ(digests.size(), 4U);
  EXPECT_EQ(digests, output_digests(folder.path() / "second"));
}

}  // namespace
}  // namespace stope::testing
