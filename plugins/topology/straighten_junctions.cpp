#include "plugins/topology/straighten_junctions.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace stope::topology {
namespace {

std::size_t at(std::int32_t place) { return static_cast<std::size_t>(place); }

/// One end of a line.
struct End {
  std::int32_t line = 0;
  bool reversed = false;  ///< the line's last point is the one at the node
};

/// How a road leaves a junction's circle: the place, and its direction outwards.
struct Exit {
  End end;
  std::size_t index = 0;  ///< of the place along the line, from the junction
  LinePoint place;
  double dx = 0, dy = 0;  ///< of the stretch beyond the place, on the whole
  double tx = 0, ty = 0;  ///< at the place itself
  bool directed = false;  ///< the road is long enough to have a direction
};

double distance_to_ray(const LinePoint& point, const Exit& exit) {
  return (point.x - exit.place.x) * exit.dy - (point.y - exit.place.y) * exit.dx;
}

double distance_to_tangent(const LinePoint& point, const Exit& exit) {
  return (point.x - exit.place.x) * exit.ty - (point.y - exit.place.y) * exit.tx;
}

/// The direction at the begin of a curve, by least squares with a parabola a way + b way^2.
class BeginDirection {
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
  void give(Exit& exit) const {
    exit.tx = x1_ * s4_ - x2_ * s3_;
    exit.ty = y1_ * s4_ - y2_ * s3_;
    const double norm = std::hypot(exit.tx, exit.ty);
    const bool known = s2_ * s4_ - s3_ * s3_ > 1e-9 * s2_ * s4_ && norm > 0;
    exit.tx = known ? exit.tx / norm : exit.dx;
    exit.ty = known ? exit.ty / norm : exit.dy;
  }

 private:
  double s2_ = 0, s3_ = 0, s4_ = 0, x1_ = 0, y1_ = 0, x2_ = 0, y2_ = 0;
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
    for (std::size_t node = 0; node < network_.nodes.size(); ++node)
      if (ends_[node].size() >= 3) straighten(node);
  }

 private:
  const LinePoint& point(End end, std::size_t i) const {
    const auto& points = network_.lines[at(end.line)].points;
    return end.reversed ? points[points.size() - 1 - i] : points[i];
  }
  std::size_t count(End end) const { return network_.lines[at(end.line)].points.size(); }

  /// The first point outside of the node's circle, within the near half of the line, and the
  /// direction of the stretch beyond it, twice as long as the road is wide to each side.
  Exit exit_of(End end, const LinePoint& node) const {
    const double half = network_.lines[at(end.line)].length / 2;
    double way = 0;
    std::size_t i = 1;
    for (; i + 1 < count(end); ++i) {
      way += distance_between(point(end, i - 1), point(end, i));
      if (way >= half || distance_between(point(end, i), node) >= node.distance) break;
    }
    Exit exit{end, i, point(end, i), 0, 0, false};
    const double wanted = 2 * exit.place.distance;
    double beyond = 0;
    BeginDirection begin;
    for (std::size_t k = i + 1; k < count(end) && beyond < wanted; ++k) {
      beyond += distance_between(point(end, k - 1), point(end, k));
      const double x = point(end, k).x - exit.place.x, y = point(end, k).y - exit.place.y;
      exit.dx += x;
      exit.dy += y;
      begin.add(beyond, x, y);
    }
    const double norm = std::hypot(exit.dx, exit.dy);
    exit.directed = beyond >= wanted / 2 && norm > 0;
    if (norm > 0) exit.dx /= norm, exit.dy /= norm;
    begin.give(exit);
    return exit;
  }

  void straighten(std::size_t node) {
    const LinePoint old = network_.nodes[node].point;
    std::vector<Exit> exits;
    for (const End end : ends_[node]) exits.push_back(exit_of(end, old));
    if (through_and_sides(node, old, exits)) return;
    if (std::count_if(exits.begin(), exits.end(), [](const Exit& e) { return e.directed; }) >= 2)
      join(node, crossing(old, exits), exits, {});
  }

  bool through_and_sides(std::size_t node, const LinePoint& old, const std::vector<Exit>& exits) {
    double best = -0.7;  // cosine: at most 45 degrees of bend
    std::size_t first = 0, second = 0;
    for (std::size_t i = 0; i < exits.size(); ++i) {
      for (std::size_t k = i + 1; k < exits.size(); ++k) {
        if (!exits[i].directed || !exits[k].directed) continue;
        const double cosine = exits[i].dx * exits[k].dx + exits[i].dy * exits[k].dy;
        if (cosine >= best) continue;
        best = cosine;
        first = i;
        second = k;
      }
    }
    if (first == second) return false;
    const std::vector<LinePoint> curve = through_curve(exits[first], exits[second], old);
    if (curve.empty()) return false;
    std::size_t nearest = curve.size() / 2;
    double least = 1e300;
    for (std::size_t i = curve.size() / 8; i < curve.size() - curve.size() / 8; ++i) {
      // Side roads often bend soon after the junction, so their direction where they leave it
      // counts, not that of what follows, and even that is not trusted all the way.
      const double back = distance_between(curve[i], old);
      double sum = 0.5 * back * back;
      for (std::size_t k = 0; k < exits.size(); ++k) {
        if (k == first || k == second) continue;
        const double off = exits[k].directed ? distance_to_tangent(curve[i], exits[k])
                                             : distance_between(curve[i], exits[k].place);
        sum += off * off;
      }
      if (sum >= least) continue;
      least = sum;
      nearest = i;
    }
    std::vector<std::vector<LinePoint>> ways(exits.size());
    for (std::size_t i = nearest; i-- > 1;) ways[first].push_back(curve[i]);
    for (std::size_t i = nearest + 1; i + 1 < curve.size(); ++i) ways[second].push_back(curve[i]);
    join(node, curve[nearest], exits, ways);
    return true;
  }

  /// A cubic with the exits' places and directions; none if it leaves the circle.
  static std::vector<LinePoint> through_curve(const Exit& a, const Exit& b, const LinePoint& old) {
    constexpr int kParts = 32;
    const double third = distance_between(a.place, b.place) / 3;
    std::vector<LinePoint> curve;
    for (int i = 0; i <= kParts; ++i) {
      const double t = static_cast<double>(i) / kParts, s = 1 - t;
      const double wa = s * s * s + 3 * s * s * t, wb = t * t * t + 3 * s * t * t;
      LinePoint point{
          wa * a.place.x + wb * b.place.x - 3 * third * (s * s * t * a.dx + s * t * t * b.dx),
          wa * a.place.y + wb * b.place.y - 3 * third * (s * s * t * a.dy + s * t * t * b.dy), 0};
      const double off = distance_between(point, old);
      const double chord = s * a.place.distance + t * b.place.distance;
      point.distance = std::max(old.distance - off, 0.0);
      if (i > kParts / 8 && i < kParts - kParts / 8 && point.distance < 0.05 * chord) return {};
      curve.push_back(point);
    }
    return curve;
  }

  static LinePoint crossing(const LinePoint& old, const std::vector<Exit>& exits) {
    // A weak pull to the old place decides where nearly parallel roads leave it open.
    constexpr double kPull = 0.05;
    double a = kPull, b = 0, c = kPull, u = 0, v = 0;
    for (const Exit& exit : exits) {
      if (!exit.directed) continue;
      const double nx = exit.dy, ny = -exit.dx, off = -distance_to_ray(old, exit);
      a += nx * nx;
      b += nx * ny;
      c += ny * ny;
      u += nx * off;
      v += ny * off;
    }
    const double determinant = a * c - b * b;
    double dx = (c * u - b * v) / determinant, dy = (a * v - b * u) / determinant;
    const double farthest = 0.5 * old.distance, step = std::hypot(dx, dy);
    if (step > farthest) {
      dx *= farthest / step;
      dy *= farthest / step;
    }
    return {old.x + dx, old.y + dy, old.distance - std::hypot(dx, dy)};
  }

  /// Lets all lines start at `place` and go on to their exits, straight or by the way given.
  void join(std::size_t node, const LinePoint& place, const std::vector<Exit>& exits,
            const std::vector<std::vector<LinePoint>>& ways) {
    for (std::size_t i = 0; i < exits.size(); ++i) {
      const End end = exits[i].end;
      auto& points = network_.lines[at(end.line)].points;
      if (end.reversed) std::reverse(points.begin(), points.end());
      // The line's other end may have been cut since, but only in its own half.
      points.erase(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(exits[i].index));
      std::vector<LinePoint> start{place};
      if (!ways.empty()) start.insert(start.end(), ways[i].begin(), ways[i].end());
      points.insert(points.begin(), start.begin(), start.end());
      if (end.reversed) std::reverse(points.begin(), points.end());
      network_.lines[at(end.line)].length = length_of(points);
    }
    network_.nodes[node].point = place;
  }

  LineNetwork& network_;
  std::vector<std::vector<End>> ends_;
};

}  // namespace

void straighten_junctions(LineNetwork& network) { Straightener(network).run(); }

}  // namespace stope::topology
