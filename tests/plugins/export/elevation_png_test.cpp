#include <gtest/gtest.h>

#include <cmath>

#include "plugins/export/draw_elevation.hpp"

namespace stope::exports {
namespace {

int brightness(Colour colour) { return colour[0] + colour[1] + colour[2]; }

// A round hill 20 m high in the middle of 900 x 900 m, one corner unknown.
Canvas draw_hill() {
  ElevationGrid grid;
  grid.frame = {900, 900, 1, {}};
  for (std::int32_t y = 0; y < 900; ++y) {
    for (std::int32_t x = 0; x < 900; ++x) {
      const double distance = std::hypot(x - 450, y - 450);
      grid.cells.push_back(static_cast<float>(std::max(0.0, 200 - distance) * 0.5));
      if (x < 50 && y < 50) grid.cells.back() = std::nanf("");
    }
  }
  return draw_elevation(grid, view_of(grid.frame, 2000));
}

TEST(DrawElevation, LightComesFromTheNorthWest) {
  const Canvas canvas = draw_hill();
  EXPECT_GT(brightness(canvas.at(380, 380)), brightness(canvas.at(520, 520)) + 100);
}

TEST(DrawElevation, UnknownIsGrey) {
  const Canvas canvas = draw_hill();
  const Colour unknown = canvas.at(10, 890);  // the lower left corner
  EXPECT_LT(std::abs(unknown[0] - unknown[2]), 15);
  EXPECT_NE(canvas.at(10, 10), unknown);
}

}  // namespace
}  // namespace stope::exports
