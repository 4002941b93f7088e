#include "plugins/topology/regions/growth_points.hpp"

#include <algorithm>
#include <cmath>

#include "stope/random.hpp"

namespace stope::topology {
namespace {

std::int32_t squared_bound(double max_radius) {
  const double squared = std::floor(max_radius * max_radius);
  return static_cast<std::int32_t>(std::clamp(squared, 1.0, 1e9));
}

/// Row after row, a change would pass on from one region to the next through all of a wide yard.
/// In an order that is as good as random, chains of regions that depend on each other are short.
std::uint64_t turn_of_square(std::int32_t column, std::int32_t row) {
  return mix_seed(static_cast<std::uint64_t>(row), static_cast<std::uint64_t>(column));
}

}  // namespace

bool tried_before(const GrowthPoint& a, const GrowthPoint& b) {
  if (a.squared != b.squared) return a.squared > b.squared;
  return a.turn != b.turn ? a.turn < b.turn : a.cell < b.cell;
}

std::int32_t spacing_in_the_open(double max_radius) {
  return std::max(1, static_cast<std::int32_t>(max_radius / 4));
}

bool is_open(std::int32_t squared, double max_radius) {
  return squared >= squared_bound(max_radius);
}

std::vector<GrowthPoint> middle_points(const Ground& ground, double max_radius,
                                       const Checkpoint& checkpoint) {
  const std::int32_t bound = squared_bound(max_radius);
  const std::int32_t spacing = spacing_in_the_open(max_radius);
  const auto steps = neighbour_steps(ground.stride());
  const auto is_middle = [&](CellIndex cell, std::int32_t squared) {
    return std::none_of(steps.begin(), steps.end(),
                        [&](CellIndex step) { return ground.squared(cell + step) > squared; });
  };
  std::vector<GrowthPoint> points;
  // Of the squares in this row of squares: whether the first cell in the open has been passed.
  std::vector<std::uint8_t> has_point(static_cast<std::size_t>(ground.width() / spacing) + 1);
  for (std::int32_t row = 0; row < ground.height(); ++row) {
    if (row % kRowsBetweenCheckpoints == 0) checkpoint();
    if (row % spacing == 0) std::fill(has_point.begin(), has_point.end(), std::uint8_t{0});
    for (std::int32_t column = 0; column < ground.width(); ++column) {
      const CellIndex cell = ground.index(column, row);
      const std::int32_t squared = ground.squared(cell);
      if (squared == 0) continue;
      if (squared < bound) {
        if (is_middle(cell, squared)) points.push_back({cell, squared, 0});
        continue;
      }
      const std::int32_t square = column / spacing;
      auto& passed = has_point[static_cast<std::size_t>(square)];
      if (!passed) points.push_back({cell, bound, turn_of_square(square, row / spacing)});
      passed = 1;
    }
  }
  std::sort(points.begin(), points.end(), tried_before);
  return points;
}

std::vector<GrowthPoint> points_at(const Ground& ground, std::vector<CellIndex> cells,
                                   double max_radius) {
  const std::int32_t bound = squared_bound(max_radius);
  std::sort(cells.begin(), cells.end());
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  std::vector<GrowthPoint> points;
  for (const CellIndex cell : cells)
    if (ground.free(cell)) points.push_back({cell, std::min(bound, ground.squared(cell)), 0});
  std::sort(points.begin(), points.end(), tried_before);
  return points;
}

}  // namespace stope::topology
