#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include "stope/payloads/occupancy_grid.hpp"
#include "stope/random.hpp"

namespace stope::topology {

/// A grid from rows of text, the highest first: '#' is an obstacle, '?' unknown, anything else
/// free.
inline OccupancyGrid grid_of(const std::vector<std::string>& rows, double resolution = 1.0) {
  OccupancyGrid grid;
  grid.frame.width = static_cast<std::int32_t>(rows.front().size());
  grid.frame.height = static_cast<std::int32_t>(rows.size());
  grid.frame.resolution = resolution;
  for (auto row = rows.rbegin(); row != rows.rend(); ++row)
    for (const char cell : *row)
      grid.cells.push_back(cell == '#'   ? OccupancyGrid::kOccupied
                           : cell == '?' ? OccupancyGrid::kUnknown
                                         : OccupancyGrid::kFree);
  return grid;
}

/// A grid whose cells are free where `free` says so of their centre, in metres.
inline OccupancyGrid grid_where(double width, double height, double resolution,
                                const std::function<bool(double, double)>& free) {
  OccupancyGrid grid;
  grid.frame.width = static_cast<std::int32_t>(std::lround(width / resolution));
  grid.frame.height = static_cast<std::int32_t>(std::lround(height / resolution));
  grid.frame.resolution = resolution;
  for (std::int32_t row = 0; row < grid.frame.height; ++row) {
    for (std::int32_t column = 0; column < grid.frame.width; ++column) {
      const Vector2 centre = grid.frame.centre({column, row});
      grid.cells.push_back(free(centre.x(), centre.y()) ? OccupancyGrid::kFree
                                                        : OccupancyGrid::kOccupied);
    }
  }
  return grid;
}

/// Cells are free with a probability, each by itself or in squares of `block` cells.
inline OccupancyGrid random_grid(std::int32_t width, std::int32_t height, double free,
                                 std::int32_t block, std::uint64_t seed) {
  Random random(seed);
  OccupancyGrid grid;
  grid.frame.width = width;
  grid.frame.height = height;
  grid.cells.assign(grid.frame.size(), OccupancyGrid::kOccupied);
  for (std::int32_t row = 0; row < height; row += block) {
    for (std::int32_t column = 0; column < width; column += block) {
      const bool is_free = random.uniform() < free;
      for (std::int32_t y = row; y < std::min(row + block, height); ++y)
        for (std::int32_t x = column; x < std::min(column + block, width); ++x)
          if (is_free) grid.cells[grid.frame.place({x, y})] = OccupancyGrid::kFree;
    }
  }
  return grid;
}

struct Point {
  double x = 0, y = 0;
};

/// A straight piece of a road's centre line.
struct Stretch {
  Point from, to;
};

inline double distance_to(const Stretch& stretch, Point point) {
  const double dx = stretch.to.x - stretch.from.x, dy = stretch.to.y - stretch.from.y;
  const double along =
      ((point.x - stretch.from.x) * dx + (point.y - stretch.from.y) * dy) / (dx * dx + dy * dy);
  const double part = std::clamp(along, 0.0, 1.0);
  return std::hypot(point.x - stretch.from.x - part * dx, point.y - stretch.from.y - part * dy);
}

inline double distance_to(const std::vector<Stretch>& stretches, Point point) {
  double least = 1e9;
  for (const Stretch& stretch : stretches) least = std::min(least, distance_to(stretch, point));
  return least;
}

/// Smooth noise between -1 and 1 whose bumps are about a metre apart at `frequency` 1.
inline double roughness(double x, double y, double frequency, std::uint64_t seed) {
  const auto value = [&](std::int64_t i, std::int64_t j) {
    const std::uint64_t key =
        static_cast<std::uint64_t>(i) * 73856093U ^ static_cast<std::uint64_t>(j) * 19349663U;
    return Random(mix_seed(seed, key)).uniform(-1.0, 1.0);
  };
  const double u = x * frequency, v = y * frequency;
  const auto i = static_cast<std::int64_t>(std::floor(u)),
             j = static_cast<std::int64_t>(std::floor(v));
  const double s = u - static_cast<double>(i), t = v - static_cast<double>(j);
  return (1 - t) * ((1 - s) * value(i, j) + s * value(i + 1, j)) +
         t * ((1 - s) * value(i, j + 1) + s * value(i + 1, j + 1));
}

}  // namespace stope::topology
