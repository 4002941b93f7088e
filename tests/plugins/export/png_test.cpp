#include <gtest/gtest.h>
#include <png.h>

#include "plugins/export/canvas.hpp"
#include "plugins/export/draw_grid.hpp"
#include "tests/plugins/export/export_samples.hpp"
#include "tests/plugins/stage_harness.hpp"

extern "C" const stope::StageEntry* stope_stage_Png();

namespace stope::exports {
namespace {

struct Picture {
  unsigned width = 0, height = 0;
  std::vector<std::uint8_t> pixels;
  Colour at(std::size_t x, std::size_t y) const {
    const std::size_t i = 3 * (y * width + x);
    return {pixels[i], pixels[i + 1], pixels[i + 2]};
  }
};

Picture decode(const std::vector<std::uint8_t>& bytes) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  EXPECT_TRUE(png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()));
  image.format = PNG_FORMAT_RGB;
  Picture picture{image.width, image.height, {}};
  picture.pixels.resize(PNG_IMAGE_SIZE(image));
  EXPECT_TRUE(png_image_finish_read(&image, nullptr, picture.pixels.data(), 0, nullptr));
  return picture;
}

int brightness(Colour colour) { return colour[0] + colour[1] + colour[2]; }

OccupancyGrid plain_grid(std::int32_t width, std::int32_t height, Pose2 origin = {}) {
  OccupancyGrid grid;
  grid.frame = {width, height, 1.0, origin};
  grid.cells.assign(grid.frame.size(), OccupancyGrid::kFree);
  return grid;
}

TEST(Canvas, WritesAPictureThatReadsBack) {
  Canvas canvas(5, 3, {1, 2, 3});
  canvas.set(4, 2, {200, 100, 50});
  const Picture picture = decode(canvas.png());
  EXPECT_EQ(picture.width, 5U);
  EXPECT_EQ(picture.height, 3U);
  EXPECT_EQ(picture.at(4, 2), (Colour{200, 100, 50}));
  EXPECT_EQ(picture.at(0, 0), (Colour{1, 2, 3}));
}

TEST(Canvas, ALineCoversItsAreaAndNoMore) {
  Canvas canvas(40, 40, {0, 0, 0});
  canvas.stroke({{Vector2(5.3, 20.2), Vector2(35.3, 20.2)}}, 3.0, {255, 255, 255});
  double sum = 0;
  for (int y = 0; y < 40; ++y) sum += canvas.at(20, y)[0] / 255.0;
  EXPECT_NEAR(sum, 3.0, 0.05);
  EXPECT_EQ(canvas.at(20, 10)[0], 0);
}

TEST(DrawGrid, NorthIsUp) {
  OccupancyGrid grid = plain_grid(800, 600);
  for (std::int32_t x = 0; x < 800; ++x)
    for (std::int32_t y = 400; y < 600; ++y) grid.cells[grid.frame.place({x, y})] = 254;
  const Canvas canvas = draw_grid(grid, view_of(grid.frame, 2000));
  EXPECT_EQ(canvas.width(), 800);
  EXPECT_LT(brightness(canvas.at(400, 10)), brightness(canvas.at(400, 590)));
}

TEST(DrawGrid, AThinBermSurvivesScalingDown) {
  OccupancyGrid grid = plain_grid(3000, 1000);
  for (std::int32_t x = 0; x < 3000; ++x) grid.cells[grid.frame.place({x, 501})] = 254;
  const Canvas canvas = draw_grid(grid, view_of(grid.frame, 300));
  EXPECT_EQ(canvas.width(), 300);
  EXPECT_EQ(canvas.height(), 100);
  for (int x = 0; x < 300; ++x) EXPECT_LT(brightness(canvas.at(x, 49)), 450);
  EXPECT_GT(brightness(canvas.at(100, 47)), 700);
}

TEST(DrawGrid, AGridWithYawIsTurnedUpright) {
  // Turned by 90 degrees, the grid's x axis points north: its right half is the picture's top.
  OccupancyGrid grid = plain_grid(400, 200, {0, 0, 1.5707963267948966});
  for (std::int32_t y = 0; y < 200; ++y)
    for (std::int32_t x = 200; x < 400; ++x) grid.cells[grid.frame.place({x, y})] = 254;
  const MapView view = view_of(grid.frame, 2000);
  const Canvas canvas = draw_grid(grid, view);
  EXPECT_EQ(canvas.height(), 2 * canvas.width());
  EXPECT_LT(brightness(canvas.at(canvas.width() / 2, 10)), 300);
  EXPECT_GT(brightness(canvas.at(canvas.width() / 2, canvas.height() - 10)), 700);
}

TEST(Png, DrawsRoadsAndPathWhereTheyAre) {
  Path path;
  path.points = {{5, 5, 0, 0, 0, 0, 0}, {25, 5, 0, 0, 0, 0, 0}};
  const auto draw = [&] {
    return stope::testing::StageHarness(stope_stage_Png())
        .input("grid", plain_grid(50, 50))
        .input("roads", sample_roads())
        .input("path", path)
        .apply<Artefact>();
  };
  const Artefact artefact = draw();
  const Picture picture = decode(artefact.files.at(0).bytes);
  ASSERT_EQ(picture.width, 400U);  // 8 pixels a cell
  const Colour on_path = picture.at(8 * 15, 400 - 8 * 5);
  EXPECT_GT(on_path[0], on_path[2] + 100);      // red
  const Colour on_road = picture.at(242, 160);  // (30.25, 30)
  EXPECT_GT(on_road[2], on_road[0] + 100);      // blue
  EXPECT_EQ(artefact.files[0].bytes, draw().files[0].bytes);
}

TEST(Png, AnEmptyGridIsRefused) {
  EXPECT_NE(stope::testing::error_of([] {
              stope::testing::StageHarness(stope_stage_Png())
                  .input("grid", OccupancyGrid{})
                  .apply<Artefact>();
            }).find("no cells"),
            std::string::npos);
}

}  // namespace
}  // namespace stope::exports
