#include "plugins/topology/regions/draw_region_road.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "plugins/topology/assemble_roads.hpp"
#include "plugins/topology/simplify_line.hpp"

namespace stope::topology {
namespace {

constexpr double kNoElevation = std::numeric_limits<double>::quiet_NaN();
constexpr double kSmoothingReach = 3.0;  // cells
constexpr double kSmoothingShare = 0.4;  // of the distance to the obstacle
constexpr double kRasterSteps = 0.75;    // cells a straight line of cells is off at most

LinePoint at_cell(const Ground& ground, CellIndex cell) {
  return {ground.column(cell) + 0.5, ground.row(cell) + 0.5,
          std::sqrt(static_cast<double>(ground.squared(cell)))};
}

bool is_free(const Ground& ground, const LinePoint& point) {
  const double x = std::floor(point.x), y = std::floor(point.y);
  if (x < 0 || y < 0 || x >= ground.width() || y >= ground.height()) return false;
  return ground.free(ground.index(static_cast<std::int32_t>(x), static_cast<std::int32_t>(y)));
}

/// Whether a line is at least this far from the centres of obstacle cells everywhere.
bool stays_clear(const Ground& ground, const std::vector<LinePoint>& line, double least) {
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double length = distance_between(line[i - 1], line[i]);
    const auto samples = static_cast<std::int32_t>(std::ceil(4 * length)) + 1;
    for (std::int32_t k = 0; k <= samples; ++k) {
      const double part = static_cast<double>(k) / samples;
      const double x = line[i - 1].x + part * (line[i].x - line[i - 1].x);
      const double y = line[i - 1].y + part * (line[i].y - line[i - 1].y);
      if (!is_free(ground, {x, y, 0}) || ground.distance_at(x, y) < least) return false;
    }
  }
  return true;
}

/// Simplified on both sides of its narrowest point, which stays.
std::vector<LinePoint> simplified(const std::vector<LinePoint>& line, double tolerance) {
  const auto narrowest = std::min_element(
      line.begin(), line.end(),
      [](const LinePoint& a, const LinePoint& b) { return a.distance < b.distance; });
  std::vector<LinePoint> result = simplify_line({line.begin(), narrowest + 1}, tolerance);
  const std::vector<LinePoint> rest = simplify_line({narrowest, line.end()}, tolerance);
  result.insert(result.end(), rest.begin() + 1, rest.end());
  return result;
}

/// A distance from the centre of an obstacle cell, as metres from its edge.
double clearance_at(double distance, const GridFrame& frame) {
  return std::max(0.0, distance - 0.5) * frame.resolution;
}

RegionRoad settled(const std::vector<LinePoint>& line, double median, const GridFrame& frame) {
  std::vector<RoadVertex> vertices;
  vertices.reserve(line.size());
  for (const LinePoint& point : line) {
    const Vector2 at = frame.to_map(point.x, point.y);
    vertices.push_back({at.x(), at.y(), kNoElevation, clearance_at(point.distance, frame)});
  }
  return {settle_road(std::move(vertices), 2 * clearance_at(median, frame), false),
          length_of(line)};
}

/// The line along these cells.
RegionRoad road_along(const Ground& ground, const std::vector<LinePoint>& cells, double tolerance,
                      double least) {
  std::vector<LinePoint> smooth, line;
  const auto drawn = [&](double share) {
    smooth = smooth_line(cells, kSmoothingReach, share);
    for (LinePoint& point : smooth) point.distance = ground.distance_at(point.x, point.y);
    line = simplified(smooth, std::max(tolerance, kRasterSteps));
    return stays_clear(ground, line, least);
  };
  if (!drawn(kSmoothingShare) && !drawn(0)) {
    smooth = cells;
    line = simplified(cells, 0);
  }
  std::vector<double> distances;
  for (const LinePoint& point : smooth) distances.push_back(point.distance);
  const auto middle = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() / 2);
  std::nth_element(distances.begin(), middle, distances.end());
  return settled(line, *middle, ground.frame());
}

}  // namespace

RegionRoad draw_region_road(const Ground& ground, const ShapePoint& first_centre,
                            const std::vector<CellIndex>& out, const std::vector<CellIndex>& in,
                            const ShapePoint& second_centre, double tolerance, double least) {
  std::vector<LinePoint> cells;
  cells.reserve(out.size() + in.size());
  for (auto cell = out.rbegin(); cell != out.rend(); ++cell)
    cells.push_back(at_cell(ground, *cell));
  for (const CellIndex cell : in) cells.push_back(at_cell(ground, cell));
  const auto centre_at = [&](LinePoint& point, const ShapePoint& centre) {
    point = {centre.x + 0.5, centre.y + 0.5, 0};
    point.distance = ground.distance_at(point.x, point.y);
  };
  centre_at(cells.front(), first_centre);
  centre_at(cells.back(), second_centre);
  return road_along(ground, cells, tolerance, least);
}

double reach_of_region_road(double tolerance) {
  return std::max(tolerance, kRasterSteps) + kSmoothingReach;
}

}  // namespace stope::topology
