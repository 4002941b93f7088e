// Problem: the road network as driven is the route, as wide as a road; exact, however fine the
// grid and however dense the poses.
// Idea: what lies within a radius of a segment is a capsule, and a row of cells cuts a capsule in
// one interval: from the two end discs and the strip between them. So each row is filled at once.
// Cost: O(rows) a segment, and the cells filled.
#include "plugins/prior/dilate_track.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stope::prior {
namespace {

struct Interval {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
  void include(double from, double to) {
    if (from > to) return;
    low = std::min(low, from);
    high = std::max(high, to);
  }
};

/// Narrows [low, high] to where a * x + b lies in [least, most].
void narrow(double a, double b, double least, double most, double& low, double& high) {
  if (a == 0) {
    if (b < least || b > most) high = low - 1;
    return;
  }
  const double first = (least - b) / a, second = (most - b) / a;
  low = std::max(low, std::min(first, second));
  high = std::min(high, std::max(first, second));
}

/// The part of the line at height `y` within `radius` of the segment from `a` to `b`.
Interval cut_capsule(const Vector2& a, const Vector2& b, double radius, double y) {
  Interval cut;
  for (const Vector2& end : {a, b}) {
    const double rise = y - end.y();
    if (std::abs(rise) > radius) continue;
    const double half = std::sqrt(radius * radius - rise * rise);
    cut.include(end.x() - half, end.x() + half);
  }
  const Vector2 span = b - a;
  const double length = span.norm();
  if (length > 0) {
    const Vector2 along = span / length;
    double low = std::min(a.x(), b.x()) - radius, high = std::max(a.x(), b.x()) + radius;
    const double rise = y - a.y();
    narrow(along.x(), along.y() * rise - along.x() * a.x(), 0, length, low, high);
    narrow(-along.y(), along.x() * rise + along.y() * a.x(), -radius, radius, low, high);
    cut.include(low, high);
  }
  return cut;
}

}  // namespace

void dilate_track(OccupancyGrid& grid, const std::vector<Vector2>& line, double radius,
                  std::uint8_t value) {
  const GridFrame& frame = grid.frame;
  const double cells = radius / frame.resolution;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const Vector2 a = frame.to_grid(line[i].x(), line[i].y());
    const Vector2& next = line[std::min(i + 1, line.size() - 1)];
    const Vector2 b = frame.to_grid(next.x(), next.y());
    const double lowest = std::min(a.y(), b.y()) - cells - 0.5;
    const double highest = std::max(a.y(), b.y()) + cells - 0.5;
    const auto first = static_cast<std::int32_t>(std::max(0.0, std::ceil(lowest)));
    const auto last =
        static_cast<std::int32_t>(std::min<double>(frame.height - 1, std::floor(highest)));
    for (std::int32_t row = first; row <= last; ++row) {
      const Interval cut = cut_capsule(a, b, cells, row + 0.5);
      const double from = std::max(0.0, std::ceil(cut.low - 0.5));
      const double to = std::min<double>(frame.width - 1, std::floor(cut.high - 0.5));
      if (from > to) continue;
      auto* cell = grid.cells.data() + frame.place({static_cast<std::int32_t>(from), row});
      std::fill(cell, cell + static_cast<std::ptrdiff_t>(to - from) + 1, value);
    }
  }
}

}  // namespace stope::prior
