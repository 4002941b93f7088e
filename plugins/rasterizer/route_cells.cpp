#include "plugins/rasterizer/route_cells.hpp"

#include <cmath>

namespace stope::rasterizer {

std::vector<std::size_t> route_cells(const GridFrame& frame, const Trajectory& trajectory) {
  constexpr double kLongestStep = 1e6;  // half cells: beyond it poses are no route
  std::vector<std::size_t> cells;
  const auto add = [&](const Vector2& point) {
    const auto cell = frame.cell_at(point.x(), point.y());
    if (cell) cells.push_back(frame.place(*cell));
  };
  for (std::size_t i = 0; i < trajectory.poses.size(); ++i) {
    const std::size_t after = i + 1 < trajectory.poses.size() ? i + 1 : i;
    const Vector2 here = trajectory.poses[i].T_map_lidar.translation.head<2>();
    const Vector2 next = trajectory.poses[after].T_map_lidar.translation.head<2>();
    const double steps = std::ceil((next - here).norm() / (0.5 * frame.resolution));
    if (!(steps < kLongestStep)) continue;
    for (double k = 0; k <= steps; ++k)
      add(steps > 0 ? Vector2(here + (k / steps) * (next - here)) : here);
  }
  return cells;
}

}  // namespace stope::rasterizer
