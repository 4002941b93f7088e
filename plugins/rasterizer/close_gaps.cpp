#include "plugins/rasterizer/close_gaps.hpp"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "plugins/rasterizer/disc_morphology.hpp"

namespace stope::rasterizer {
namespace {

float ground_at(const LocalGround& ground, const Vector2& point) {
  const auto cell = ground.frame.cell_at(point.x(), point.y());
  return cell ? ground.height[ground.frame.place(*cell)] : std::numeric_limits<float>::quiet_NaN();
}

/// How much the ground of the free cells within `reach` cells differs.
float step_around(const OccupancyGrid& grid, const LocalGround& ground, Cell cell,
                  std::int32_t reach) {
  float low = std::numeric_limits<float>::infinity(), high = -low;
  for (std::int32_t dy = -reach; dy <= reach; ++dy) {
    for (std::int32_t dx = -reach; dx <= reach; ++dx) {
      const Cell near{cell.column + dx, cell.row + dy};
      if (!grid.frame.contains(near) || grid.cells[grid.frame.place(near)] != OccupancyGrid::kFree)
        continue;
      const float height = ground_at(ground, grid.frame.centre(near));
      low = std::min(low, height);
      high = std::max(high, height);
    }
  }
  return high - low;
}

}  // namespace

void close_gaps(OccupancyGrid& grid, const LocalGround& ground, double gap, double most_step) {
  const double radius = gap / 2 / grid.frame.resolution;
  if (radius < 0.5) return;
  const Mask occupied = close(cells_equal(grid, OccupancyGrid::kOccupied), radius);
  for (std::size_t i = 0; i < grid.cells.size(); ++i) {
    if (occupied.cells[i] != 0 && grid.cells[i] == OccupancyGrid::kUnknown)
      grid.cells[i] = OccupancyGrid::kOccupied;
  }
  const Mask free = close(cells_equal(grid, OccupancyGrid::kFree), radius);
  const auto reach = static_cast<std::int32_t>(std::ceil(radius)) + 1;
  const OccupancyGrid before = grid;
  tbb::parallel_for(0, grid.frame.height, [&](std::int32_t row) {
    for (std::int32_t column = 0; column < grid.frame.width; ++column) {
      const std::size_t i = grid.frame.place({column, row});
      if (free.cells[i] == 0 || before.cells[i] != OccupancyGrid::kUnknown) continue;
      if (step_around(before, ground, {column, row}, reach) <= static_cast<float>(most_step))
        grid.cells[i] = OccupancyGrid::kFree;
    }
  });
}

}  // namespace stope::rasterizer
