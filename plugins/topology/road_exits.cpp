#include "plugins/topology/road_exits.hpp"

#include <algorithm>
#include <cmath>

namespace stope::topology {
namespace {

constexpr double kAsNarrow = 1.06;  // of the narrowest place near the junction
constexpr double kFit = 2;          // clearances of road that tell how it goes on

double cross(double ax, double ay, double bx, double by) { return ax * by - ay * bx; }

/// The direction and curvature at the begin of a curve, by least squares with a parabola
/// a way + b way^2.
class BeginFit {
 public:
  void add(double way, double x, double y) {
    const double square = way * way;
    s2_ += square;
    s3_ += square * way;
    s4_ += square * square;
    x1_ += way * x;
    y1_ += way * y;
    x2_ += square * x;
    y2_ += square * y;
  }
  void give(RoadExit& exit) const {
    const double determinant = s2_ * s4_ - s3_ * s3_;
    if (!(determinant > 1e-9 * s2_ * s4_)) return;
    const double ax = (x1_ * s4_ - x2_ * s3_) / determinant;
    const double ay = (y1_ * s4_ - y2_ * s3_) / determinant;
    const double bx = (x2_ * s2_ - x1_ * s3_) / determinant;
    const double by = (y2_ * s2_ - y1_ * s3_) / determinant;
    const double norm = std::hypot(ax, ay);
    if (!(norm > 0)) return;
    exit.dx = ax / norm;
    exit.dy = ay / norm;
    exit.curvature = 2 * cross(ax, ay, bx, by) / (norm * norm * norm);
  }

 private:
  double s2_ = 0, s3_ = 0, s4_ = 0, x1_ = 0, y1_ = 0, x2_ = 0, y2_ = 0;
};

}  // namespace

RoadExit find_exit(const std::vector<RoadEnd>& ends, std::size_t end, const LinePoint& node,
                   double flare) {
  const CourseView& points = ends[end].points;
  const double half = ends[end].length / 2;
  double narrow = node.distance, way = 0;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    way += distance_between(points[i - 1], points[i]);
    if (way >= std::min(half, flare * node.distance)) break;
    narrow = std::min(narrow, points[i].distance);
  }
  way = 0;
  std::size_t i = 1;
  for (; i + 1 < points.size(); ++i) {
    way += distance_between(points[i - 1], points[i]);
    if (way >= half) break;
    if (distance_between(points[i], node) < node.distance) continue;
    if (way >= flare * node.distance || points[i].distance <= kAsNarrow * narrow) break;
  }
  RoadExit exit{end, i, points[i], 0, 0, 0, false};
  const double wanted = kFit * exit.place.distance;
  double beyond = 0;
  BeginFit begin;
  for (std::size_t k = i + 1; k < points.size() && beyond < wanted; ++k) {
    beyond += distance_between(points[k - 1], points[k]);
    const double x = points[k].x - exit.place.x, y = points[k].y - exit.place.y;
    exit.dx += x;
    exit.dy += y;
    begin.add(beyond, x, y);
  }
  const double norm = std::hypot(exit.dx, exit.dy);
  exit.directed = beyond >= wanted / 2 && norm > 0;
  if (norm > 0) exit.dx /= norm, exit.dy /= norm;
  if (exit.directed) begin.give(exit);
  return exit;
}

double turn_between(const RoadExit& a, const RoadExit& b) {
  return std::abs(std::atan2(cross(-a.dx, -a.dy, b.dx, b.dy), -a.dx * b.dx - a.dy * b.dy));
}

double mismatch(const RoadExit& a, const RoadExit& b) {
  const double x = b.place.x - a.place.x, y = b.place.y - a.place.y;
  const double into = std::atan2(cross(-a.dx, -a.dy, x, y), -a.dx * x - a.dy * y);
  const double out = std::atan2(cross(x, y, b.dx, b.dy), x * b.dx + y * b.dy);
  const double own = (b.curvature - a.curvature) / 2 * std::hypot(x, y);
  return std::abs(into + out - own) + 0.5 * std::abs(into - out);
}

double distance_to_continuation(const LinePoint& point, const RoadExit& exit, double share) {
  const double x = point.x - exit.place.x, y = point.y - exit.place.y;
  const double inwards = -(x * exit.dx + y * exit.dy);
  return cross(exit.dx, exit.dy, x, y) - 0.5 * share * exit.curvature * inwards * inwards;
}

LinePoint crossing_of(const std::vector<RoadExit>& exits, const LinePoint& node) {
  // A weak pull to the old place decides where nearly parallel roads leave it open.
  constexpr double kPull = 0.05;
  double a = kPull, b = 0, c = kPull, u = 0, v = 0;
  for (const RoadExit& exit : exits) {
    if (!exit.directed) continue;
    const double nx = exit.dy, ny = -exit.dx,
                 off = cross(node.x - exit.place.x, node.y - exit.place.y, -exit.dx, -exit.dy);
    a += nx * nx;
    b += nx * ny;
    c += ny * ny;
    u += nx * off;
    v += ny * off;
  }
  const double determinant = a * c - b * b;
  double dx = (c * u - b * v) / determinant, dy = (a * v - b * u) / determinant;
  const double farthest = 0.5 * node.distance, step = std::hypot(dx, dy);
  if (step > farthest) {
    dx *= farthest / step;
    dy *= farthest / step;
  }
  return {node.x + dx, node.y + dy, node.distance - std::hypot(dx, dy)};
}

}  // namespace stope::topology
