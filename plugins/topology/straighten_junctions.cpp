#include "plugins/topology/straighten_junctions.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace stope::topology {
namespace {

// Beyond a junction's circle roads are widened by its corners, mostly to this many radii.
constexpr double kFlare = 2.2;
constexpr double kAsNarrow = 1.06;       // of the narrowest place there
constexpr double kFit = 2;               // clearances of road that tell how it goes on
constexpr double kMostMismatch = 0.4;    // radians; worse pairs are two roads that meet
constexpr double kCurvatureShare = 0.5;  // of a side road, whose continuation is not seen
constexpr double kPull = 0.25;           // of the old place against side roads' continuations
constexpr double kLeastClearance = 0.2;  // of what a new line has at its ends

std::size_t at(std::int32_t place) { return static_cast<std::size_t>(place); }

/// One end of a line at a junction.
struct End {
  CourseView points;     ///< from the junction on
  double length = 0;     ///< of the line
  std::size_t line = 0;  ///< among those of the junction
};

/// How a road leaves a junction: from where on it is itself again, and how it goes on from there.
struct Exit {
  std::size_t end = 0;    ///< among those of the junction
  std::size_t index = 0;  ///< of the place along the line, from the junction
  LinePoint place;
  double dx = 0, dy = 0;  ///< direction outwards at the place
  double curvature = 0;   ///< there, of the way outwards; to the left is positive
  bool directed = false;  ///< the road is long enough to have a direction
};

double cross(double ax, double ay, double bx, double by) { return ax * by - ay * bx; }

/// How far a point is off the road's own continuation into the junction, drawn as a parabola of
/// `share` of its curvature.
double distance_to_continuation(const LinePoint& point, const Exit& exit, double share) {
  const double x = point.x - exit.place.x, y = point.y - exit.place.y;
  const double inwards = -(x * exit.dx + y * exit.dy);
  return cross(exit.dx, exit.dy, x, y) - 0.5 * share * exit.curvature * inwards * inwards;
}

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
  void give(Exit& exit) const {
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
    for (const double flare : {kFlare, 0.0}) {
      exits.clear();
      for (std::size_t end = 0; end < ends_.size(); ++end) exits.push_back(exit_of(end, flare));
      if (through_and_sides(exits)) return true;
    }
    if (std::count_if(exits.begin(), exits.end(), [](const Exit& e) { return e.directed; }) < 2)
      return false;
    join(crossing(exits), exits, {});
    return true;
  }

  const LinePoint& node() const { return node_; }
  /// The lines in the direction of their first end.
  std::vector<std::vector<LinePoint>>& lines() { return lines_; }

 private:
  /// A road is itself again where it is about as narrow as it gets within `flare` radii of the
  /// node's circle, but at the earliest on the circle's rim. Within the near half of the line.
  Exit exit_of(std::size_t end, double flare) const {
    const CourseView& points = ends_[end].points;
    const double half = ends_[end].length / 2;
    double narrow = node_.distance, way = 0;
    for (std::size_t i = 1; i + 1 < points.size(); ++i) {
      way += distance_between(points[i - 1], points[i]);
      if (way >= std::min(half, flare * node_.distance)) break;
      narrow = std::min(narrow, points[i].distance);
    }
    way = 0;
    std::size_t i = 1;
    for (; i + 1 < points.size(); ++i) {
      way += distance_between(points[i - 1], points[i]);
      if (way >= half) break;
      if (distance_between(points[i], node_) < node_.distance) continue;
      if (way >= flare * node_.distance || points[i].distance <= kAsNarrow * narrow) break;
    }
    Exit exit{end, i, points[i], 0, 0, 0, false};
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

  /// How badly two roads continue each other: what is left of the turn from one to the other when
  /// their own curvature has made its part, and how far that turn is from an arc's; radians.
  static double mismatch(const Exit& a, const Exit& b) {
    const double x = b.place.x - a.place.x, y = b.place.y - a.place.y;
    const double into = std::atan2(cross(-a.dx, -a.dy, x, y), -a.dx * x - a.dy * y);
    const double out = std::atan2(cross(x, y, b.dx, b.dy), x * b.dx + y * b.dy);
    const double own = (b.curvature - a.curvature) / 2 * std::hypot(x, y);
    return std::abs(into + out - own) + 0.5 * std::abs(into - out);
  }

  bool through_and_sides(const std::vector<Exit>& exits) {
    double best = kMostMismatch;
    std::size_t first = 0, second = 0;
    for (std::size_t i = 0; i < exits.size(); ++i) {
      for (std::size_t k = i + 1; k < exits.size(); ++k) {
        if (!exits[i].directed || !exits[k].directed) continue;
        const double here = mismatch(exits[i], exits[k]);
        if (here >= best) continue;
        best = here;
        first = i;
        second = k;
      }
    }
    if (first == second) return false;
    const std::vector<LinePoint> circles = circles_around(exits);
    const std::vector<LinePoint> curve = through_curve(exits[first], exits[second], circles);
    if (curve.empty()) return false;
    std::size_t nearest = curve.size() / 2;
    double least = 1e300;
    for (std::size_t i = curve.size() / 8; i < curve.size() - curve.size() / 8; ++i) {
      // A side road's continuation is not trusted all the way.
      const double back = distance_between(curve[i], node_);
      double sum = kPull * back * back;
      for (std::size_t k = 0; k < exits.size(); ++k) {
        if (k == first || k == second) continue;
        const double off = exits[k].directed
                               ? distance_to_continuation(curve[i], exits[k], kCurvatureShare)
                               : distance_between(curve[i], exits[k].place);
        sum += off * off;
      }
      if (sum >= least) continue;
      least = sum;
      nearest = i;
    }
    for (std::size_t k = 0; k < exits.size(); ++k)
      if (k != first && k != second && !free_between(exits[k].place, curve[nearest], circles))
        return false;
    std::vector<std::vector<LinePoint>> ways(exits.size());
    for (std::size_t i = nearest; i-- > 1;) ways[first].push_back(curve[i]);
    for (std::size_t i = nearest + 1; i + 1 < curve.size(); ++i) ways[second].push_back(curve[i]);
    join(curve[nearest], exits, ways);
    return true;
  }

  /// Circles that are known to be free: the node's, and some along the lines up to the exits.
  std::vector<LinePoint> circles_around(const std::vector<Exit>& exits) const {
    std::vector<LinePoint> circles{node_};
    for (const Exit& exit : exits) {
      const std::size_t step = exit.index / 8 + 1;
      for (std::size_t i = step; i < exit.index; i += step)
        circles.push_back(ends_[exit.end].points[i]);
      circles.push_back(exit.place);
    }
    return circles;
  }

  /// A lower bound of the distance to obstacles.
  static double known_distance(const LinePoint& place, const std::vector<LinePoint>& circles) {
    double known = 0;
    for (const LinePoint& circle : circles)
      known = std::max(known, circle.distance - distance_between(place, circle));
    return known;
  }

  static bool free_between(const LinePoint& a, const LinePoint& b,
                           const std::vector<LinePoint>& circles) {
    constexpr int kParts = 16;
    const double least = kLeastClearance * std::min(a.distance, b.distance);
    for (int i = 1; i < kParts; ++i) {
      const double part = static_cast<double>(i) / kParts;
      const LinePoint place{a.x + part * (b.x - a.x), a.y + part * (b.y - a.y), 0};
      if (known_distance(place, circles) < least) return false;
    }
    return true;
  }

  /// A cubic with the exits' places and directions, nearly an arc where these allow one; none if it
  /// leaves the circles.
  static std::vector<LinePoint> through_curve(const Exit& a, const Exit& b,
                                              const std::vector<LinePoint>& circles) {
    constexpr int kParts = 32;
    const double turn =
        std::abs(std::atan2(cross(-a.dx, -a.dy, b.dx, b.dy), -a.dx * b.dx - a.dy * b.dy));
    // Handles of a cubic that is nearly a circle's arc; a third of the chord for small turns.
    const double share = turn < 0.01 ? 1.0 / 3 : 2.0 / 3 * std::tan(turn / 4) / std::sin(turn / 2);
    const double handle = distance_between(a.place, b.place) * share;
    std::vector<LinePoint> curve;
    for (int i = 0; i <= kParts; ++i) {
      const double t = static_cast<double>(i) / kParts, s = 1 - t;
      const double wa = s * s * s + 3 * s * s * t, wb = t * t * t + 3 * s * t * t;
      LinePoint place{
          wa * a.place.x + wb * b.place.x - 3 * handle * (s * s * t * a.dx + s * t * t * b.dx),
          wa * a.place.y + wb * b.place.y - 3 * handle * (s * s * t * a.dy + s * t * t * b.dy), 0};
      place.distance = known_distance(place, circles);
      const double chord = s * a.place.distance + t * b.place.distance;
      if (place.distance < kLeastClearance * chord) return {};
      curve.push_back(place);
    }
    return curve;
  }

  LinePoint crossing(const std::vector<Exit>& exits) const {
    // A weak pull to the old place decides where nearly parallel roads leave it open.
    constexpr double kPull = 0.05;
    double a = kPull, b = 0, c = kPull, u = 0, v = 0;
    for (const Exit& exit : exits) {
      if (!exit.directed) continue;
      const double nx = exit.dy, ny = -exit.dx,
                   off = cross(node_.x - exit.place.x, node_.y - exit.place.y, -exit.dx, -exit.dy);
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
