// Problem: exact dilation by a disc of any size, without visiting the disc's cells for each cell.
// Idea: a cell is within reach if some column has a set cell at height h from it whose half chord
// sqrt(r² - h²) spans the columns between. So the distance to the nearest set cell is found along
// each column, then each cell opens an interval in its row; intervals are added up as differences.
// Cost: three passes over the cells, in parallel.
#include "plugins/rasterizer/disc_morphology.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

namespace stope::rasterizer {
namespace {

constexpr std::uint16_t kFar = 65535;

/// Cells up or down to the nearest set cell of the column, at most kFar.
std::vector<std::uint16_t> distance_along_columns(const Mask& mask) {
  const auto width = static_cast<std::size_t>(mask.width);
  const auto height = static_cast<std::size_t>(mask.height);
  std::vector<std::uint16_t> distance(mask.cells.size());
  tbb::parallel_for(tbb::blocked_range<std::size_t>(0, width, 256), [&](const auto& columns) {
    const auto step = [&](std::size_t row, std::size_t x, std::uint16_t neighbour) {
      const std::size_t i = row * width + x;
      const auto farther = static_cast<std::uint16_t>(std::min<int>(neighbour + 1, kFar));
      distance[i] = mask.cells[i] != 0 ? 0 : std::min(distance[i], farther);
    };
    for (std::size_t row = 0; row < height; ++row) {
      for (std::size_t x = columns.begin(); x < columns.end(); ++x) {
        distance[row * width + x] = kFar;
        step(row, x, row > 0 ? distance[(row - 1) * width + x] : kFar);
      }
    }
    for (std::size_t row = height; row-- > 1;) {
      for (std::size_t x = columns.begin(); x < columns.end(); ++x)
        step(row - 1, x, distance[row * width + x]);
    }
  });
  return distance;
}

}  // namespace

Mask cells_equal(const OccupancyGrid& grid, std::uint8_t value) {
  Mask mask{grid.frame.width, grid.frame.height, std::vector<std::uint8_t>(grid.cells.size())};
  for (std::size_t i = 0; i < grid.cells.size(); ++i)
    mask.cells[i] = grid.cells[i] == value ? 1 : 0;
  return mask;
}

Mask dilate(const Mask& mask, double radius) {
  const auto reach = static_cast<std::int32_t>(std::clamp(std::floor(radius), 0.0, 65000.0));
  std::vector<std::int32_t> half_chord(static_cast<std::size_t>(reach) + 1);
  for (std::size_t h = 0; h < half_chord.size(); ++h) {
    const double square = radius * radius - static_cast<double>(h * h);
    half_chord[h] = static_cast<std::int32_t>(std::floor(std::sqrt(std::max(0.0, square))));
  }
  const std::vector<std::uint16_t> distance = distance_along_columns(mask);
  Mask result{mask.width, mask.height, std::vector<std::uint8_t>(mask.cells.size())};
  tbb::parallel_for(0, mask.height, [&](std::int32_t row) {
    const auto width = static_cast<std::size_t>(mask.width);
    const std::size_t first = static_cast<std::size_t>(row) * width;
    std::vector<std::int32_t> change(width + 1);
    for (std::int32_t x = 0; x < mask.width; ++x) {
      const std::uint16_t h = distance[first + static_cast<std::size_t>(x)];
      if (h > reach) continue;
      const std::int32_t half = half_chord[h];
      ++change[static_cast<std::size_t>(std::max(0, x - half))];
      --change[static_cast<std::size_t>(std::min(mask.width, x + half + 1))];
    }
    std::int32_t open = 0;
    for (std::size_t x = 0; x < width; ++x) {
      open += change[x];
      result.cells[first + x] = open > 0 ? 1 : 0;
    }
  });
  return result;
}

Mask close(const Mask& mask, double radius) {
  Mask outside = dilate(mask, radius);
  for (std::uint8_t& cell : outside.cells) cell = cell != 0 ? 0 : 1;
  Mask result = dilate(outside, radius);
  for (std::uint8_t& cell : result.cells) cell = cell != 0 ? 0 : 1;
  return result;
}

}  // namespace stope::rasterizer
