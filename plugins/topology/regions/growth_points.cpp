#include "plugins/topology/regions/growth_points.hpp"

#include <algorithm>
#include <cmath>

namespace stope::topology {
namespace {

std::int32_t squared_bound(double max_radius) {
  const double squared = std::floor(max_radius * max_radius);
  return static_cast<std::int32_t>(std::clamp(squared, 1.0, 1e9));
}

}  // namespace

bool tried_before(const GrowthPoint& a, const GrowthPoint& b) {
  return a.squared != b.squared ? a.squared > b.squared : a.cell < b.cell;
}

std::vector<GrowthPoint> middle_points(const Ground& ground, double max_radius,
                                       const Checkpoint& checkpoint) {
  const std::int32_t bound = squared_bound(max_radius);
  const auto spacing = std::max(1, static_cast<std::int32_t>(max_radius / 4));
  const auto steps = neighbour_steps(ground.stride());
  std::vector<GrowthPoint> points;
  for (std::int32_t row = 0; row < ground.height(); ++row) {
    if (row % kRowsBetweenCheckpoints == 0) checkpoint();
    for (std::int32_t column = 0; column < ground.width(); ++column) {
      const CellIndex cell = ground.index(column, row);
      const std::int32_t squared = std::min(bound, ground.squared(cell));
      if (squared == 0) continue;
      if (squared == bound && (column % spacing != 0 || row % spacing != 0)) continue;
      if (std::any_of(steps.begin(), steps.end(),
                      [&](CellIndex step) { return ground.squared(cell + step) > squared; }) &&
          squared < bound)
        continue;
      points.push_back({cell, squared});
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
    if (ground.free(cell)) points.push_back({cell, std::min(bound, ground.squared(cell))});
  std::sort(points.begin(), points.end(), tried_before);
  return points;
}

}  // namespace stope::topology
