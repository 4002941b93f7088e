#include "plugins/topology/straighten_junctions.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace stope::topology {
namespace {

std::size_t at(std::int32_t place) { return static_cast<std::size_t>(place); }

/// One end of a line.
struct End {
  std::int32_t line = 0;
  bool reversed = false;  ///< the line's last point is the one at the node
};

/// A line through a place, with its direction.
struct Ray {
  double x = 0, y = 0, dx = 0, dy = 0;
};

class Straightener {
 public:
  explicit Straightener(LineNetwork& network) : network_(network), ends_(network.nodes.size()) {
    for (std::size_t i = 0; i < network.lines.size(); ++i) {
      const Line& line = network.lines[i];
      ends_[at(line.from)].push_back({static_cast<std::int32_t>(i), false});
      ends_[at(line.to)].push_back({static_cast<std::int32_t>(i), true});
    }
  }

  void run() {
    // Directions are taken from all lines before any is changed.
    std::vector<std::optional<LinePoint>> places(network_.nodes.size());
    for (std::size_t node = 0; node < network_.nodes.size(); ++node)
      if (ends_[node].size() >= 3) places[node] = crossing(node);
    for (std::size_t node = 0; node < network_.nodes.size(); ++node)
      if (places[node]) move(node, *places[node]);
  }

 private:
  const LinePoint& point(End end, std::size_t i) const {
    const auto& points = network_.lines[at(end.line)].points;
    return end.reversed ? points[points.size() - 1 - i] : points[i];
  }
  std::size_t count(End end) const { return network_.lines[at(end.line)].points.size(); }

  /// The first point outside of the node's circle, within the near half of the line.
  std::size_t exit_of(End end, const LinePoint& node) const {
    const double half = network_.lines[at(end.line)].length() / 2;
    double way = 0;
    std::size_t i = 1;
    for (; i + 1 < count(end); ++i) {
      way += distance_between(point(end, i - 1), point(end, i));
      if (way >= half || distance_between(point(end, i), node) >= node.distance) break;
    }
    return i;
  }

  /// The direction in which a road goes on beyond the circle, fitted to a stretch three of its
  /// half widths long; none where the line is too short for that.
  std::optional<Ray> road_beyond(End end, const LinePoint& node) const {
    const std::size_t exit = exit_of(end, node);
    const double wanted = 3 * point(end, exit).distance;
    double way = 0, x = 0, y = 0, n = 0;
    std::size_t last = exit;
    for (; last < count(end) && way < wanted; ++last) {
      if (last > exit) way += distance_between(point(end, last - 1), point(end, last));
      x += point(end, last).x;
      y += point(end, last).y;
      ++n;
    }
    if (way < wanted / 2) return std::nullopt;
    x /= n;
    y /= n;
    double xx = 0, xy = 0, yy = 0;
    for (std::size_t i = exit; i < last; ++i) {
      const double dx = point(end, i).x - x, dy = point(end, i).y - y;
      xx += dx * dx;
      xy += dx * dy;
      yy += dy * dy;
    }
    const double angle = 0.5 * std::atan2(2 * xy, xx - yy);
    return Ray{x, y, std::cos(angle), std::sin(angle)};
  }

  std::optional<LinePoint> crossing(std::size_t node) const {
    // A weak pull to the old place decides where nearly parallel roads leave it open.
    constexpr double kPull = 0.05;
    const LinePoint& old = network_.nodes[node].point;
    double a = kPull, b = 0, c = kPull, u = 0, v = 0;
    int rays = 0;
    for (const End end : ends_[node]) {
      const std::optional<Ray> ray = road_beyond(end, old);
      if (!ray) continue;
      ++rays;
      const double nx = -ray->dy, ny = ray->dx;
      const double off = nx * (ray->x - old.x) + ny * (ray->y - old.y);
      a += nx * nx;
      b += nx * ny;
      c += ny * ny;
      u += nx * off;
      v += ny * off;
    }
    if (rays < 2) return std::nullopt;
    const double determinant = a * c - b * b;
    double dx = (c * u - b * v) / determinant, dy = (a * v - b * u) / determinant;
    const double farthest = 0.5 * old.distance, step = std::hypot(dx, dy);
    if (step > farthest) {
      dx *= farthest / step;
      dy *= farthest / step;
    }
    return LinePoint{old.x + dx, old.y + dy, old.distance - std::hypot(dx, dy)};
  }

  void move(std::size_t node, const LinePoint& place) {
    const LinePoint old = network_.nodes[node].point;
    for (const End end : ends_[node]) {
      const std::size_t exit = exit_of(end, old);
      auto& points = network_.lines[at(end.line)].points;
      if (end.reversed) std::reverse(points.begin(), points.end());
      points.erase(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(exit) - 1);
      points.front() = place;
      if (end.reversed) std::reverse(points.begin(), points.end());
    }
    network_.nodes[node].point = place;
  }

  LineNetwork& network_;
  std::vector<std::vector<End>> ends_;
};

}  // namespace

void straighten_junctions(LineNetwork& network) { Straightener(network).run(); }

}  // namespace stope::topology
