#include <gtest/gtest.h>
#include <png.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>

#include "plugins/topology/extract_roads.hpp"
#include "plugins/topology/regions/room_divider.hpp"
#include "tests/plugins/topology/graph_checks.hpp"
#include "tests/plugins/topology/members.hpp"
#include "tests/plugins/topology/recorded_tracks.hpp"

namespace stope::topology {
namespace {

std::filesystem::path maps() {
  const char* data = std::getenv("STOPE_DATA");
  const std::filesystem::path folder = data ? data : STOPE_DEFAULT_DATA;
  return folder / "open_pit_maps";
}
std::filesystem::path mine() { return maps() / "dapai_0p5m.png"; }

OccupancyGrid read_mask(const std::filesystem::path& file, double resolution) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  if (!png_image_begin_read_from_file(&image, file.c_str())) return {};
  image.format = PNG_FORMAT_GRAY;
  std::vector<std::uint8_t> pixels(PNG_IMAGE_SIZE(image));
  png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr);
  OccupancyGrid grid;
  grid.frame = {static_cast<std::int32_t>(image.width),
                static_cast<std::int32_t>(image.height),
                resolution,
                {909.468, 246.355, 0}};
  grid.cells.reserve(grid.frame.size());
  for (std::size_t row = image.height; row-- > 0;)
    for (std::size_t column = 0; column < image.width; ++column)
      grid.cells.push_back(pixels[row * image.width + column] > 127 ? OccupancyGrid::kFree
                                                                    : OccupancyGrid::kOccupied);
  return grid;
}

class RealMine : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists(mine()))
      GTEST_SKIP() << "the mine's raster " << mine() << " is not there; set STOPE_DATA";
    grid = read_mask(mine(), 0.5);
    ASSERT_EQ(grid.cells.size(), 4216U * 2591U);
  }
  OccupancyGrid grid;
};

// Its free space is one piece with seven holes of 197394, 105024, 22094, 2172, 1319, 1151 and
// 436 square metres. The default min_clearance of 2 m cuts none of the ways around them.
TEST_F(RealMine, KeepsOneCycleForEachHoleOfAtLeastTheAreaAskedFor) {
  const std::vector<double> areas = hole_areas(grid);
  const std::vector<double> published{197394, 105024, 22094, 2172, 1319, 1151, 436};
  ASSERT_EQ(areas.size(), published.size());
  // Published of the raster of 0.1 m.
  for (std::size_t i = 0; i < areas.size(); ++i)
    EXPECT_NEAR(areas[i], published[i], 1 + 0.001 * published[i]);
  for (const Member& member : members()) {
    for (std::size_t i = 0; i < areas.size(); ++i) {
      ExtractionParams params;
      params.min_obstacle_area = areas[i];
      const auto holes = static_cast<int>(i) + 1;
      EXPECT_EQ(betti_of(member.extract(grid, params)), (Betti{1, holes}))
          << member.name << ", at least " << areas[i] << " m^2";
      params.min_obstacle_area = areas[i] + 0.25;
      EXPECT_EQ(betti_of(member.extract(grid, params)).cycles, holes - 1)
          << member.name << ", more than " << areas[i] << " m^2";
    }
    EXPECT_EQ(betti_of(member.extract(grid, {})), (Betti{1, 7})) << member.name;
  }
}

// Both ways into the southern yard, 7 m wide and more, are in one region with a part of the yard.
TEST_F(RealMine, RoadsBetweenRoomsAreOneNetworkWithACycleForEachHole) {
  for (const double min_clearance : {1.0, 0.0}) {
    ExtractionParams params;
    params.min_clearance = min_clearance;
    RegionRoadsRule rule;
    rule.min_clearance = min_clearance;
    const RegionsAndRoads rooms = RoomDivider(params, {}, rule).full(grid, false);
    EXPECT_EQ(betti_of(rooms.roads), (Betti{1, 7}));
    for (const RoadEdge& edge : rooms.roads.edges) EXPECT_GE(edge.min_clearance, 1.5);
  }
}

TEST_F(RealMine, RecordedTracksLieWithinTheClearanceOfARoad) {
  const auto tracks = read_tracks(maps() / "scenarios");
  ASSERT_EQ(tracks.size(), 11U);
  for (const Member& member : members()) {
    const RoadGraph roads = member.extract(grid, {});
    const TrackCover cover = cover_of(tracks, roads);
    EXPECT_GT(cover.length, 600) << "metres driven";
    // Trucks load and dump in dead ends, which a watershed of whole obstacles does not have.
    EXPECT_GE(cover.within / cover.length, member.has_dead_ends ? 0.99 : 0.8) << member.name;
  }
}

TEST_F(RealMine, EveryMemberWithDeadEndsFindsTheSameOnes) {
  const RoadGraph reference = voronoi_roads(grid, {}, {});
  const auto ends = nodes_of_degree(reference, 1);
  EXPECT_EQ(ends.size(), 17U);
  for (const Member& member : members()) {
    if (!member.has_dead_ends) continue;
    const auto found = nodes_of_degree(member.extract(grid, {}), 1);
    EXPECT_EQ(found.size(), ends.size()) << member.name;
    for (const RoadNode& end : ends) {
      double nearest = 1e9;
      for (const RoadNode& node : found)
        nearest = std::min(nearest, std::hypot(node.x - end.x, node.y - end.y));
      // A line between parts of an outline begins at the corner that parts them.
      EXPECT_LE(nearest, member.name == "watershed of parts" ? 6 : 4)
          << member.name << " at " << end.x << ", " << end.y;
    }
  }
}

TEST_F(RealMine, RoadsStayInFreeSpaceWithTheirClearance) {
  for (const Member& member : members()) {
    const RoadGraph roads = member.extract(grid, {});
    for (const RoadEdge& edge : roads.edges) {
      EXPECT_GE(edge.min_clearance, 1.5);
      const auto line = roads.polyline(edge);
      for (std::size_t i = 1; i < line.size(); ++i) {
        for (int k = 0; k <= 20; ++k) {
          const double x = line[i - 1].x + k / 20.0 * (line[i].x - line[i - 1].x);
          const double y = line[i - 1].y + k / 20.0 * (line[i].y - line[i - 1].y);
          const auto cell = grid.frame.cell_at(x, y);
          ASSERT_TRUE(cell) << x << ", " << y;
          ASSERT_EQ(grid.cells[grid.frame.place(*cell)], OccupancyGrid::kFree) << x << ", " << y;
        }
      }
    }
  }
}

}  // namespace
}  // namespace stope::topology
