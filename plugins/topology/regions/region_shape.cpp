#include "plugins/topology/regions/region_shape.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "plugins/topology/for_each_band.hpp"

namespace stope::topology {

RegionShape& RegionShape::operator+=(const RegionShape& other) {
  cells += other.cells;
  x += other.x;
  y += other.y;
  xx += other.xx;
  xy += other.xy;
  yy += other.yy;
  hull = joined_hull(hull, other.hull);
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

RegionShape shape_of(const Ground& ground, const PaddedGrid<std::int32_t>& names,
                     const RegionSet& set, std::int32_t region,
                     std::span<const std::int32_t> tiles) {
  const TileSet geometry(ground.width(), ground.height());
  struct Extent {
    std::int32_t left = INT32_MAX, right = -1;
  };
  // Tiles increase, so the first has the lowest rows.
  std::int32_t bottom = ground.height(), top = -1;
  for (const std::int32_t tile : tiles) {
    geometry.for_each_row(tile, [&](CellIndex first, std::int32_t) {
      bottom = std::min(bottom, ground.row(first));
      top = std::max(top, ground.row(first));
    });
  }
  std::vector<Extent> extents(static_cast<std::size_t>(std::max(0, top - bottom + 1)));
  RegionShape shape;
  const auto add_run = [&](std::int64_t row, std::int64_t first, std::int64_t last) {
    const std::int64_t n = last + 1 - first, sum = n * (first + last) / 2;
    shape.cells += n;
    shape.x += sum;
    shape.y += n * row;
    shape.xy += sum * row;
    shape.yy += n * row * row;
    const auto squares = [](std::int64_t k) { return k * (k + 1) * (2 * k + 1) / 6; };
    shape.xx += squares(last) - squares(first - 1);
    Extent& extent = extents[static_cast<std::size_t>(row - bottom)];
    extent.left = std::min(extent.left, static_cast<std::int32_t>(first));
    extent.right = std::max(extent.right, static_cast<std::int32_t>(last));
  };
  for (const std::int32_t tile : tiles) {
    geometry.for_each_row(tile, [&](CellIndex begin, std::int32_t count) {
      const std::int32_t row = ground.row(begin), column = ground.column(begin);
      for (std::int32_t i = 0; i < count;) {
        const std::int32_t name = names[begin + i], first = i;
        while (i < count && names[begin + i] == name) ++i;
        if (name != 0 && set.of(name) == region) add_run(row, column + first, column + i - 1);
      }
    });
  }
  std::vector<HullPoint> points;
  for (std::size_t i = 0; i < extents.size(); ++i) {
    const auto row = bottom + static_cast<std::int32_t>(i);
    if (extents[i].right < 0) continue;
    points.push_back({extents[i].left, row});
    if (extents[i].right > extents[i].left) points.push_back({extents[i].right, row});
  }
  shape.hull = convex_hull(std::move(points));
  return shape;
}

std::vector<std::int32_t> update_shapes(const Ground& ground, const PaddedGrid<std::int32_t>& names,
                                        const RegionSet& set, const TileParts& tiles,
                                        const MovedCells* moved, std::vector<RegionShape>& shapes,
                                        const Checkpoint& checkpoint) {
  const std::size_t known = moved ? shapes.size() : 0;
  shapes.resize(set.of_name.size());
  std::vector<std::int32_t> stale;
  for (std::size_t name = 1; name < set.of_name.size(); ++name)
    if (set.of_name[name] != 0 &&
        (name >= known || moved->has_name(static_cast<std::int32_t>(name))))
      stale.push_back(static_cast<std::int32_t>(name));
  for_each_band(static_cast<std::int32_t>(stale.size()), checkpoint, [&] {
    return [&](std::int32_t i) {
      const std::int32_t name = stale[static_cast<std::size_t>(i)];
      const auto place = static_cast<std::size_t>(name);
      shapes[place] = shape_of(ground, names, set, set.of_name[place], tiles.tiles_of(name));
    };
  });
  return stale;
}

}  // namespace stope::topology
