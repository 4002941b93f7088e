#include <fmt/format.h>

#include <cmath>

#include "framework/report/draw/colour_ramp.hpp"
#include "framework/report/draw/grid_picture.hpp"
#include "framework/report/draw/sketches.hpp"
#include "framework/report/quantity_text.hpp"

namespace stope::report {

Sketch sketch_of(const DistanceGrid& grid) {
  Sketch sketch;
  sketch.kind = "Distance to obstacles";
  if (!is_whole(grid)) {
    sketch.caption = "no cells";
    return sketch;
  }
  float farthest = 0;
  for (const float metres : grid.cells) {
    if (std::isfinite(metres)) farthest = std::max(farthest, metres);
  }
  sketch.caption =
      fmt::format("{}; up to {} away", grid_size_text(grid.frame), length_text(farthest));
  // Steps keep the palette small; the square root spends them where roads are narrow.
  constexpr int kSteps = 96;
  std::array<Colour, kSteps + 1> colours{};
  for (std::size_t i = 0; i < colours.size(); ++i)
    colours[i] = distance_ramp().at(static_cast<double>(i) / kSteps);
  const float scale = farthest > 0 ? 1.0F / farthest : 0.0F;
  sketch.raster = Raster{
      grid.frame,
      grid_picture(grid.frame, grid.cells,
                   [&](float metres) -> Colour {
                     if (!std::isfinite(metres)) return {0, 0, 0, 0};
                     if (metres <= 0) return {166, 166, 166, 255};
                     return colours[static_cast<std::size_t>(std::sqrt(metres * scale) * kSteps)];
                   }),
      false};
  return sketch;
}

}  // namespace stope::report
