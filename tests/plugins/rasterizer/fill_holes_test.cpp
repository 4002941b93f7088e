#include "plugins/rasterizer/fill_holes.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace stope::rasterizer {
namespace {

constexpr std::uint8_t kF = OccupancyGrid::kFree, kO = OccupancyGrid::kOccupied;
constexpr std::uint8_t kU = OccupancyGrid::kUnknown;

struct Scene {
  OccupancyGrid grid;
  LocalGround ground;

  // 40 x 40 m of free level ground in cells of half a metre.
  Scene() {
    grid.frame = {80, 80, 0.5, {}};
    grid.cells.assign(grid.frame.size(), kF);
    ground.frame = grid.frame;
    ground.height.assign(grid.frame.size(), 0);
  }
  void fill(std::int32_t left, std::int32_t bottom, std::int32_t size, std::uint8_t value) {
    for (std::int32_t y = bottom; y < bottom + size; ++y)
      for (std::int32_t x = left; x < left + size; ++x)
        grid.cells[grid.frame.place({x, y})] = value;
  }
  std::uint8_t at(std::int32_t x, std::int32_t y) const {
    return grid.cells[grid.frame.place({x, y})];
  }
  void fill_holes(double most_area = 25) {
    stope::rasterizer::fill_holes(grid, ground, most_area, 0.5, 0.3);
  }
};

TEST(FillHoles, FillsUpToTheAreaAndNoMore) {
  Scene scene;
  scene.fill(10, 10, 10, kU);  // 25 m²
  scene.fill(40, 40, 11, kU);  // 30 m²
  scene.fill_holes();
  EXPECT_EQ(scene.at(15, 15), kF);
  EXPECT_EQ(scene.at(45, 45), kU);
}

TEST(FillHoles, AHoleThatTouchesAnObstacleOrTheEdgeStays) {
  Scene scene;
  scene.fill(10, 10, 4, kU);
  scene.fill(14, 14, 1, kO);  // by a corner
  scene.fill(0, 40, 4, kU);
  scene.fill_holes();
  EXPECT_EQ(scene.at(11, 11), kU);
  EXPECT_EQ(scene.at(1, 41), kU);
}

TEST(FillHoles, AHoleThatHidesAStepStays) {
  Scene scene;
  scene.fill(10, 10, 4, kU);
  scene.fill(40, 10, 4, kU);
  for (std::int32_t y = 0; y < 80; ++y) {
    for (std::int32_t x = 12; x < 30; ++x)
      scene.ground.height[scene.grid.frame.place({x, y})] = 3;  // a bench
    for (std::int32_t x = 30; x < 80; ++x)
      scene.ground.height[scene.grid.frame.place({x, y})] = 3 + 0.05F * static_cast<float>(x - 30);
  }
  scene.fill_holes();
  EXPECT_EQ(scene.at(11, 11), kU);
  EXPECT_EQ(scene.at(41, 11), kF);  // on a ramp of 10 %
}

}  // namespace
}  // namespace stope::rasterizer
