#include "plugins/topology/straighten_junctions.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace stope::topology {
namespace {

std::size_t at(std::int32_t place) { return static_cast<std::size_t>(place); }

/// One end of a line at a junction.
struct End {
  CourseView points;     ///< from the junction on
  double length = 0;     ///< of the line
  std::size_t line = 0;  ///< among those of the junction
};

/// How a road leaves a junction's circle: the place, and its direction outwards.
struct Exit {
  std::size_t end = 0;    ///< among those of the junction
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

/// Straightens the lines that meet in one node.
class Straightener {
 public:
  Straightener(const std::vector<End>& ends, const LinePoint& node) : ends_(ends), node_(node) {
    for (const End& end : ends)
      if (end.line == lines_.size()) lines_.push_back(end.points.copy());
  }

  /// Whether the lines are others now.
  bool run() {
    std::vector<Exit> exits;
    for (std::size_t end = 0; end < ends_.size(); ++end) exits.push_back(exit_of(end));
    if (through_and_sides(exits)) return true;
    if (std::count_if(exits.begin(), exits.end(), [](const Exit& e) { return e.directed; }) < 2)
      return false;
    join(crossing(exits), exits, {});
    return true;
  }

  const LinePoint& node() const { return node_; }
  /// The lines in the direction of their first end.
  std::vector<std::vector<LinePoint>>& lines() { return lines_; }

 private:
  /// The first point outside of the node's circle, within the near half of the line, and the
  /// direction of the stretch beyond it, twice as long as the road is wide to each side.
  Exit exit_of(std::size_t end) const {
    const CourseView& points = ends_[end].points;
    const double half = ends_[end].length / 2;
    double way = 0;
    std::size_t i = 1;
    for (; i + 1 < points.size(); ++i) {
      way += distance_between(points[i - 1], points[i]);
      if (way >= half || distance_between(points[i], node_) >= node_.distance) break;
    }
    Exit exit{end, i, points[i], 0, 0, 0, 0, false};
    const double wanted = 2 * exit.place.distance;
    double beyond = 0;
    BeginDirection begin;
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
    begin.give(exit);
    return exit;
  }

  bool through_and_sides(const std::vector<Exit>& exits) {
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
    const std::vector<LinePoint> curve = through_curve(exits[first], exits[second]);
    if (curve.empty()) return false;
    std::size_t nearest = curve.size() / 2;
    double least = 1e300;
    for (std::size_t i = curve.size() / 8; i < curve.size() - curve.size() / 8; ++i) {
      // Side roads often bend soon after the junction, so their direction where they leave it
      // counts, not that of what follows, and even that is not trusted all the way.
      const double back = distance_between(curve[i], node_);
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
    join(curve[nearest], exits, ways);
    return true;
  }

  /// A cubic with the exits' places and directions; none if it leaves the circle.
  std::vector<LinePoint> through_curve(const Exit& a, const Exit& b) const {
    constexpr int kParts = 32;
    const double third = distance_between(a.place, b.place) / 3;
    std::vector<LinePoint> curve;
    for (int i = 0; i <= kParts; ++i) {
      const double t = static_cast<double>(i) / kParts, s = 1 - t;
      const double wa = s * s * s + 3 * s * s * t, wb = t * t * t + 3 * s * t * t;
      LinePoint point{
          wa * a.place.x + wb * b.place.x - 3 * third * (s * s * t * a.dx + s * t * t * b.dx),
          wa * a.place.y + wb * b.place.y - 3 * third * (s * s * t * a.dy + s * t * t * b.dy), 0};
      const double off = distance_between(point, node_);
      const double chord = s * a.place.distance + t * b.place.distance;
      point.distance = std::max(node_.distance - off, 0.0);
      if (i > kParts / 8 && i < kParts - kParts / 8 && point.distance < 0.05 * chord) return {};
      curve.push_back(point);
    }
    return curve;
  }

  LinePoint crossing(const std::vector<Exit>& exits) const {
    // A weak pull to the old place decides where nearly parallel roads leave it open.
    constexpr double kPull = 0.05;
    double a = kPull, b = 0, c = kPull, u = 0, v = 0;
    for (const Exit& exit : exits) {
      if (!exit.directed) continue;
      const double nx = exit.dy, ny = -exit.dx, off = -distance_to_ray(node_, exit);
      a += nx * nx;
      b += nx * ny;
      c += ny * ny;
      u += nx * off;
      v += ny * off;
    }
    const double determinant = a * c - b * b;
    double dx = (c * u - b * v) / determinant, dy = (a * v - b * u) / determinant;
    const double farthest = 0.5 * node_.distance, step = std::hypot(dx, dy);
    if (step > farthest) {
      dx *= farthest / step;
      dy *= farthest / step;
    }
    return {node_.x + dx, node_.y + dy, node_.distance - std::hypot(dx, dy)};
  }

  /// Lets all lines start at `place` and go on to their exits, straight or by the way given.
  void join(const LinePoint& place, const std::vector<Exit>& exits,
            const std::vector<std::vector<LinePoint>>& ways) {
    std::vector<bool> seen(lines_.size(), false);
    for (std::size_t i = 0; i < exits.size(); ++i) {
      const End& end = ends_[exits[i].end];
      std::vector<LinePoint>& points = lines_[end.line];
      // A line that leads back to the junction is worked on from both ends.
      const bool from_back = seen[end.line];
      seen[end.line] = true;
      if (from_back) std::reverse(points.begin(), points.end());
      // The line's other end may have been cut since, but only in its own half.
      points.erase(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(exits[i].index));
      std::vector<LinePoint> start{place};
      if (!ways.empty()) start.insert(start.end(), ways[i].begin(), ways[i].end());
      points.insert(points.begin(), start.begin(), start.end());
      if (from_back) std::reverse(points.begin(), points.end());
    }
    node_ = place;
  }

  std::vector<End> ends_;
  LinePoint node_;
  std::vector<std::vector<LinePoint>> lines_;
};

/// The ends at a node; a line's end and its other one count as of one line.
std::vector<End> ends_at(const LineNetwork& network, std::int32_t node,
                         std::span<const std::int32_t> lines) {
  std::vector<End> ends;
  std::size_t count = 0;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const Line& line = network.lines[at(lines[i])];
    const bool again = i > 0 && lines[i] == lines[i - 1];
    const bool reversed = again || line.from != node;
    const CourseId course = reversed ? backwards(line.course) : line.course;
    ends.push_back({network.courses->view(course), line.length, again ? count - 1 : count});
    if (!again) ++count;
  }
  return ends;
}

}  // namespace

void straighten_junctions(LineNetwork& network) {
  Courses& courses = *network.courses;
  const LinesAtNodes at_nodes(network);
  for (std::int32_t node = 0; node < static_cast<std::int32_t>(network.nodes.size()); ++node) {
    const auto lines = at_nodes[node];
    if (lines.size() < 3) continue;
    CourseKey key(CourseKey::kStraightened);
    key.add(network.nodes[at(node)].point);
    for (const std::int32_t line : lines) {
      const bool reversed = network.lines[at(line)].from != node;
      const CourseId course = network.lines[at(line)].course;
      key.add(courses.name(reversed ? backwards(course) : course));
    }
    const Courses::Made& straight = courses.make(key, [&] {
      Straightener straightener(ends_at(network, node, lines), network.nodes[at(node)].point);
      Courses::Made made;
      if (!straightener.run()) return made;
      for (std::vector<LinePoint>& points : straightener.lines())
        made.courses.push_back(courses.add(std::move(points)));
      made.place = straightener.node();
      return made;
    });
    if (straight.courses.empty()) continue;
    network.nodes[at(node)].point = straight.place;
    auto course = straight.courses.begin();
    for (std::size_t i = 0; i < lines.size(); ++i) {
      if (i > 0 && lines[i] == lines[i - 1]) continue;
      Line& line = network.lines[at(lines[i])];
      const bool reversed = line.from != node;
      network.set_course(line, reversed ? backwards(*course) : *course);
      ++course;
    }
  }
}

}  // namespace stope::topology
