#include <gtest/gtest.h>
#include <png.h>

#include <cstdlib>
#include <filesystem>

#include "plugins/topology/extract_roads.hpp"
#include "tests/plugins/topology/graph_checks.hpp"

namespace stope::topology {
namespace {

std::filesystem::path mine() {
  const char* data = std::getenv("STOPE_DATA");
  const std::filesystem::path folder = data ? data : STOPE_DEFAULT_DATA;
  return folder / "open_pit_maps" / "dapai_0p5m.png";
}

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
                {}};
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

// Its free space is one piece with seven holes, the smallest of 436 square metres.
TEST_F(RealMine, VoronoiKeepsOneCycleForEachHole) {
  ExtractionParams params;
  params.min_obstacle_area = 400;
  EXPECT_EQ(betti_of(voronoi_roads(grid, params, {})), (Betti{1, 7}));
  EXPECT_EQ(betti_of(voronoi_roads(grid, {}, {})), (Betti{1, 7}));
  params.min_obstacle_area = 2000;
  EXPECT_EQ(betti_of(voronoi_roads(grid, params, {})), (Betti{1, 4}));
}

TEST_F(RealMine, WatershedKeepsOneCycleForEachHole) {
  ExtractionParams params;
  params.min_obstacle_area = 400;
  EXPECT_EQ(betti_of(watershed_roads(grid, params)).cycles, 7);
  EXPECT_EQ(betti_of(watershed_roads(grid, {})).cycles, 7);
}

TEST_F(RealMine, RoadsStayInFreeSpaceWithTheirClearance) {
  for (const RoadGraph& roads : {voronoi_roads(grid, {}, {}), watershed_roads(grid, {})}) {
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
