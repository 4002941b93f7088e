#include <fmt/format.h>

#include "framework/report/draw/colour_ramp.hpp"
#include "framework/report/draw/grid_picture.hpp"
#include "framework/report/draw/sketches.hpp"

namespace stope::report {
namespace {

struct Shares {
  double free = 0, occupied = 0, unknown = 0;  ///< percent
};

// Of every so-many-th row: enough for two digits.
Shares shares_of(const OccupancyGrid& grid) {
  std::array<std::uint64_t, 256> counts{};
  const int step = std::max(1, grid.frame.height / 2000);
  std::uint64_t total = 0;
  for (int row = 0; row < grid.frame.height; row += step) {
    const std::uint8_t* cell = grid.cells.data() + grid.frame.place({0, row});
    for (int column = 0; column < grid.frame.width; ++column) ++counts[cell[column]];
    total += static_cast<std::uint64_t>(grid.frame.width);
  }
  // As map_server divides: free below 0.196, occupied above 0.65.
  std::uint64_t free = 0, occupied = 0;
  for (int value = 0; value < 255; ++value) {
    if (value / 254.0 < 0.196) free += counts[static_cast<std::size_t>(value)];
    if (value / 254.0 > 0.65) occupied += counts[static_cast<std::size_t>(value)];
  }
  const double percent = 100.0 / static_cast<double>(total);
  return {static_cast<double>(free) * percent, static_cast<double>(occupied) * percent,
          static_cast<double>(counts[OccupancyGrid::kUnknown]) * percent};
}

}  // namespace

Sketch sketch_of(const OccupancyGrid& grid) {
  Sketch sketch;
  sketch.kind = "Occupancy grid";
  if (!is_whole(grid)) {
    sketch.caption = "no cells";
    return sketch;
  }
  std::array<Colour, 256> colours{};
  for (int value = 0; value < 256; ++value)
    colours[static_cast<std::size_t>(value)] = occupancy_colour(static_cast<std::uint8_t>(value));
  const Shares shares = shares_of(grid);
  sketch.caption =
      fmt::format("{}; {:.0f} % free, {:.0f} % occupied, {:.0f} % unknown",
                  grid_size_text(grid.frame), shares.free, shares.occupied, shares.unknown);
  sketch.raster = Raster{
      grid.frame,
      grid_picture(grid.frame, grid.cells, [&](std::uint8_t value) { return colours[value]; }),
      true};
  return sketch;
}

}  // namespace stope::report
