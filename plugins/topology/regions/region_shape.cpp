#include "plugins/topology/regions/region_shape.hpp"

#include <algorithm>
#include <cmath>

namespace stope::topology {

RegionShape& RegionShape::operator+=(const RegionShape& other) {
  cells += other.cells;
  x += other.x;
  y += other.y;
  xx += other.xx;
  xy += other.xy;
  yy += other.yy;
  hull.insert(hull.end(), other.hull.begin(), other.hull.end());
  hull = convex_hull(std::move(hull));
  return *this;
}

Axes RegionShape::axes() const {
  if (cells == 0) return {};
  const auto n = static_cast<double>(cells);
  const double mx = static_cast<double>(x) / n, my = static_cast<double>(y) / n;
  // A cell is a square of side 1, which has a variance of its own.
  const double a = static_cast<double>(xx) / n - mx * mx + 1.0 / 12;
  const double c = static_cast<double>(yy) / n - my * my + 1.0 / 12;
  const double b = static_cast<double>(xy) / n - mx * my;
  const double middle = (a + c) / 2, spread = std::hypot((a - c) / 2, b);
  // A filled ellipse has a quarter of a semi-axis' square as its variance.
  return {2 * std::sqrt(middle + spread), 2 * std::sqrt(std::max(0.0, middle - spread)),
          0.5 * std::atan2(2 * b, a - c)};
}

double RegionShape::radius() const {
  const Axes found = axes();
  return std::max(0.5, std::sqrt(found.major * found.minor));
}

ShapePoint centre_of_gravity(const std::vector<HullPoint>& polygon, const HullPoint& pivot) {
  double area = 0, x = 0, y = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const HullPoint &a = polygon[i], &b = polygon[i + 1 < polygon.size() ? i + 1 : 0];
    const double s = static_cast<double>(cross(pivot, a, b)) / 2;
    area += s;
    x += (static_cast<double>(pivot.x) + a.x + b.x) * s;
    y += (static_cast<double>(pivot.y) + a.y + b.y) * s;
  }
  if (area != 0) return {x / (3 * area), y / (3 * area)};
  ShapePoint mean;
  for (const HullPoint& corner : polygon) {
    mean.x += corner.x / static_cast<double>(polygon.size());
    mean.y += corner.y / static_cast<double>(polygon.size());
  }
  return mean;
}

std::vector<RegionShape> shapes_of(const Ground& ground, const RegionCells& regions,
                                   std::int32_t count, const Checkpoint& checkpoint) {
  std::vector<RegionShape> shapes(static_cast<std::size_t>(count));
  for (std::int32_t row = 0; row < ground.height(); ++row) {
    if (row % kRowsBetweenCheckpoints == 0) checkpoint();
    for (std::int32_t column = 0; column < ground.width();) {
      const std::int32_t region = regions[ground.index(column, row)];
      const std::int32_t first = column;
      while (column < ground.width() && regions[ground.index(column, row)] == region) ++column;
      if (region == 0) continue;
      RegionShape& shape = shapes[static_cast<std::size_t>(region) - 1];
      const std::int64_t n = column - first, last = column - 1;
      const std::int64_t sum = n * (first + last) / 2;
      shape.cells += n;
      shape.x += sum;
      shape.y += n * row;
      shape.xy += sum * row;
      shape.yy += n * row * row;
      const auto squares = [](std::int64_t k) { return k * (k + 1) * (2 * k + 1) / 6; };
      shape.xx += squares(last) - squares(std::int64_t{first} - 1);
      shape.hull.push_back({first, row});
      if (last > first) shape.hull.push_back({static_cast<std::int32_t>(last), row});
    }
  }
  for (RegionShape& shape : shapes) shape.hull = convex_hull(std::move(shape.hull));
  return shapes;
}

}  // namespace stope::topology
