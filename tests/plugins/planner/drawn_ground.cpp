#include "tests/plugins/planner/drawn_ground.hpp"

#include <algorithm>
#include <cmath>

#include "stope/geometry.hpp"

namespace stope::planner {

Path path_of(const Places& places) {
  Path path;
  for (const auto& [x, y] : places) {
    PathPoint point;
    point.x = x, point.y = y;
    path.points.push_back(point);
  }
  return path;
}

OccupancyGrid free_ground(std::int32_t width, std::int32_t height) {
  OccupancyGrid grid;
  grid.frame = {width, height, 0.5, {}};
  grid.cells.assign(grid.frame.size(), OccupancyGrid::kFree);
  return grid;
}

OccupancyGrid roads_of(double width, const std::vector<Places>& lines, bool round) {
  OccupancyGrid grid = free_ground(420, 260);
  grid.cells.assign(grid.frame.size(), OccupancyGrid::kOccupied);
  for (const Places& line : lines) {
    for (std::size_t i = 1; i < line.size(); ++i) {
      const Vector2 a(line[i - 1].first, line[i - 1].second), b(line[i].first, line[i].second);
      for (std::int32_t row = 0; row < grid.frame.height; ++row) {
        for (std::int32_t column = 0; column < grid.frame.width; ++column) {
          const Vector2 at = grid.frame.centre({column, row}) - a, way = b - a;
          const double along = at.dot(way) / way.norm();
          const double beyond = std::max({0.0, -along, along - way.norm()});
          const double aside = std::abs(at.x() * way.y() - at.y() * way.x()) / way.norm();
          const bool inside =
              round ? std::hypot(beyond, aside) <= width / 2 : std::max(beyond, aside) <= width / 2;
          if (inside) grid.cells[grid.frame.place({column, row})] = OccupancyGrid::kFree;
        }
      }
    }
  }
  return grid;
}

void fill(OccupancyGrid& grid, double left, double bottom, double right, double top,
          std::uint8_t value) {
  for (std::int32_t row = 0; row < grid.frame.height; ++row) {
    for (std::int32_t column = 0; column < grid.frame.width; ++column) {
      const Vector2 centre = grid.frame.centre({column, row});
      if (centre.x() > left && centre.x() < right && centre.y() > bottom && centre.y() < top)
        grid.cells[grid.frame.place({column, row})] = value;
    }
  }
}

}  // namespace stope::planner
