// A relief: tint by height, shade by slope (light from the north-west, 45 degrees high), as Horn
// (1981) computes it. Both are taken in steps so that the picture needs no more than 256 colours.
// One pass over the grid and one over the picture.
#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "framework/report/draw/colour_ramp.hpp"
#include "framework/report/draw/grid_picture.hpp"
#include "framework/report/draw/sketches.hpp"
#include "framework/report/quantity_text.hpp"

namespace stope::report {
namespace {

constexpr int kTints = 31, kShades = 8;

struct Heights {
  int width = 0, height = 0;
  std::vector<double> metres;  ///< by pixel, row 0 at the top; NaN: not known
  double lowest = std::numeric_limits<double>::infinity();
  double highest = -std::numeric_limits<double>::infinity();
  double at(int x, int y) const {
    x = std::clamp(x, 0, width - 1);
    y = std::clamp(y, 0, height - 1);
    return metres[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
};

Heights mean_heights(const ElevationGrid& grid) {
  const Blocks blocks(grid.frame);
  Heights heights{blocks.picture_width, blocks.picture_height, {}};
  for (int y = 0; y < heights.height; ++y) {
    for (int x = 0; x < heights.width; ++x) {
      double sum = 0;
      int count = 0;
      for (int row = blocks.row_begin(y); row < blocks.row_end(y); row += blocks.row_step(y)) {
        for (int column = blocks.column_begin(x); column < blocks.column_begin(x + 1); ++column) {
          const float metres = grid.cells[grid.frame.place({column, row})];
          if (!std::isfinite(metres)) continue;
          sum += metres;
          ++count;
        }
      }
      const double mean = count > 0 ? sum / count : std::numeric_limits<double>::quiet_NaN();
      heights.metres.push_back(mean);
      if (count > 0) {
        heights.lowest = std::min(heights.lowest, mean);
        heights.highest = std::max(heights.highest, mean);
      }
    }
  }
  return heights;
}

// How bright the ground is at a pixel of `metres` a side: 0 to 1.
double light_at(const Heights& heights, int x, int y, double metres) {
  const double here = heights.at(x, y);
  const auto around = [&](int dx, int dy) {
    const double other = heights.at(x + dx, y + dy);
    return std::isnan(other) ? here : other;
  };
  const double east = (around(1, 0) - around(-1, 0)) / (2 * metres);
  const double north = (around(0, -1) - around(0, 1)) / (2 * metres);
  // The light comes from (-1, 1, sqrt 2) / 2.
  return std::max(0.0, (east - north + std::sqrt(2.0)) / 2 / std::hypot(east, north, 1.0));
}

Picture relief(const Heights& heights, double metres) {
  Picture picture{heights.width, heights.height, {}};
  const double range = std::max(heights.highest - heights.lowest, 1e-9);
  for (int y = 0; y < heights.height; ++y) {
    for (int x = 0; x < heights.width; ++x) {
      const double height = heights.at(x, y);
      Colour colour{};
      if (!std::isnan(height)) {
        const double tint = std::round((height - heights.lowest) / range * (kTints - 1));
        const double light = std::min(light_at(heights, x, y, metres), 1.0);
        const double shade = 0.45 + 0.65 * std::round(light * (kShades - 1)) / (kShades - 1);
        colour = height_ramp().at(tint / (kTints - 1));
        for (std::size_t k = 0; k < 3; ++k)
          colour[k] = static_cast<std::uint8_t>(std::min(255.0, colour[k] * shade));
      }
      picture.pixels.push_back(colour);
    }
  }
  return picture;
}

}  // namespace

Sketch sketch_of(const ElevationGrid& grid) {
  Sketch sketch;
  sketch.kind = "Elevation";
  if (!is_whole(grid)) {
    sketch.caption = "no cells";
    return sketch;
  }
  const Heights heights = mean_heights(grid);
  sketch.caption = grid_size_text(grid.frame);
  if (heights.lowest <= heights.highest)
    sketch.caption +=
        fmt::format("; {} to {} high", length_text(heights.lowest), length_text(heights.highest));
  const double metres = grid.frame.resolution * grid.frame.width / heights.width;
  sketch.raster = Raster{grid.frame, relief(heights, metres), false};
  return sketch;
}

}  // namespace stope::report
