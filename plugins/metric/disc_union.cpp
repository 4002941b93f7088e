#include "plugins/metric/disc_union.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "plugins/metric/obstacle_edges.hpp"

namespace stope::metric {
namespace {

class Cover {
 public:
  explicit Cover(const FreeCells& cells)
      : cells_(cells),
        obstacles_(cells),
        whole_{Vector2::Zero(), Vector2(cells.frame.width, cells.frame.height)},
        covered_(cells.free.size()) {}

  // Covers the disc round a point; how far the next point may be.
  double add(const Vector2& point) {
    const double radius = obstacles_.distance(point, point);
    if (radius <= 0) return std::max(0.5, whole_.distance(box_of(point, point)));
    const auto low = std::max(0.0, std::ceil(point.y() - radius - 0.5));
    const auto high = std::min(cells_.frame.height - 1.0, std::floor(point.y() + radius - 0.5));
    for (double row = low; row <= high; ++row) {
      const double up = row + 0.5 - point.y();
      const double half = std::sqrt(std::max(0.0, radius * radius - up * up));
      const auto begin = static_cast<std::int32_t>(std::ceil(point.x() - half - 0.5));
      const auto end = static_cast<std::int32_t>(std::floor(point.x() + half - 0.5));
      if (begin > end) continue;
      const auto at =
          covered_.begin() +
          static_cast<std::ptrdiff_t>(cells_.frame.place({begin, static_cast<std::int32_t>(row)}));
      std::fill(at, at + (end - begin + 1), std::uint8_t{1});
    }
    return 0.25 * std::max(1.0, radius / 16);
  }
  std::size_t count() const {
    std::size_t sum = 0;
    for (std::size_t i = 0; i < covered_.size(); ++i) sum += covered_[i] & cells_.free[i];
    return sum;
  }

 private:
  const FreeCells& cells_;
  ObstacleEdges obstacles_;
  Box whole_;  // the map
  std::vector<std::uint8_t> covered_;
};

}  // namespace

std::size_t cells_in_discs(const RoadGraph& graph, const FreeCells& cells) {
  Cover cover(cells);
  for (const RoadNode& node : graph.nodes) cover.add(cells.frame.to_grid(node.x, node.y));
  for (const RoadEdge& edge : graph.edges) {
    const auto line = graph.polyline(edge);
    for (std::size_t i = 1; i < line.size(); ++i) {
      const Vector2 a = cells.frame.to_grid(line[i - 1].x, line[i - 1].y);
      const Vector2 b = cells.frame.to_grid(line[i].x, line[i].y);
      const double length = (b - a).norm();
      for (double along = 0; along < length;) along += cover.add(a + along / length * (b - a));
      cover.add(b);
    }
  }
  return cover.count();
}

}  // namespace stope::metric
