// Problem: a map of 273 million cells must become a picture of a few million pixels in which a berm
// of one cell can still be seen.
// Idea: cells are pooled in squares of k x k along the grid's own axes, then each pixel takes the
// square under its centre, which also turns a grid with yaw north up.
// Cost: one pass over the cells, in parallel by rows of squares.
#include "plugins/export/draw_grid.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace stope::exports {
namespace {

constexpr Colour kFree{252, 251, 247}, kOccupied{66, 72, 82}, kUnknown{199, 203, 209};
constexpr Colour kOutside{226, 229, 233};
constexpr double kDarkest = 0.7;  // at least this dark where a cell is occupied

struct Pool {
  std::uint32_t occupancy = 0, known = 0, unknown = 0;
  bool obstacle = false;

  void add(std::uint8_t cell) {
    if (cell == OccupancyGrid::kUnknown) {
      ++unknown;
    } else {
      ++known;
      occupancy += cell;
      obstacle = obstacle || cell >= 165;
    }
  }

  Colour colour() const {
    const double all = std::max<double>(1.0, static_cast<double>(known) + unknown);
    const double dark = occupancy / 254.0 / all;
    const double grey = unknown / all;
    const double darker = obstacle ? std::max(dark, kDarkest) : dark;
    const double greyer = std::min(grey, 1 - darker);
    Colour mixed{};
    for (std::size_t i = 0; i < 3; ++i) {
      mixed[i] = static_cast<std::uint8_t>(std::lround(
          darker * kOccupied[i] + greyer * kUnknown[i] + (1 - darker - greyer) * kFree[i]));
    }
    return mixed;
  }
};

}  // namespace

Canvas draw_grid(const OccupancyGrid& grid, const MapView& view) {
  const GridFrame& frame = grid.frame;
  const int size = cells_per_pixel(view, frame);
  const int columns = (frame.width + size - 1) / size, rows = (frame.height + size - 1) / size;
  std::vector<Colour> pooled(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  tbb::parallel_for(0, rows, [&](int row) {
    std::vector<Pool> pools(static_cast<std::size_t>(columns));
    const int last = std::min(frame.height, (row + 1) * size);
    for (int y = row * size; y < last; ++y) {
      const std::uint8_t* cells = grid.cells.data() + frame.place({0, y});
      for (int x = 0; x < frame.width; ++x) pools[static_cast<std::size_t>(x / size)].add(cells[x]);
    }
    for (std::size_t column = 0; column < pools.size(); ++column) {
      pooled[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + column] =
          pools[column].colour();
    }
  });

  Canvas canvas(view.width, view.height, kOutside);
  for (int y = 0; y < view.height; ++y) {
    for (int x = 0; x < view.width; ++x) {
      const Vector2 point = view.to_map(x + 0.5, y + 0.5);
      const auto cell = frame.cell_at(point.x(), point.y());
      if (!cell) continue;
      canvas.set(
          x, y,
          pooled[static_cast<std::size_t>(cell->row / size) * static_cast<std::size_t>(columns) +
                 static_cast<std::size_t>(cell->column / size)]);
    }
  }
  return canvas;
}

}  // namespace stope::exports
