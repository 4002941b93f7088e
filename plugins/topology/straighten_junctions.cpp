// Problem: at a junction the line that is equally far from all obstacles bends towards every
// opening, so that no road goes through as it is driven.
// Idea: cut the roads off where the junction's corners no longer widen them. Two that continue each
// other by direction and curvature become one curve, and the others run straight to it, at the
// place nearest to their own continuations; without such two, all meet nearest to all of these.
// What is new stays within circles that are known to be free.
// Cost: for each junction its roads up to a few radii of its circle; made once for equal roads.
#include "plugins/topology/straighten_junctions.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "plugins/topology/free_circles.hpp"
#include "plugins/topology/road_exits.hpp"

namespace stope::topology {
namespace {

// Beyond a junction's circle roads are widened by its corners, mostly to this many radii.
constexpr double kFlare = 2.2;
constexpr double kMostMismatch = 0.4;    // radians; worse pairs are two roads that meet
constexpr double kCurvatureShare = 0.5;  // of a side road, whose continuation is not seen
constexpr double kPull = 0.25;           // of the old place against side roads' continuations
constexpr double kLeastClearance = 0.2;  // of what a new line has at its ends

std::size_t at(std::int32_t place) { return static_cast<std::size_t>(place); }

/// Straightens the lines that meet in one node.
class Straightener {
 public:
  Straightener(const std::vector<RoadEnd>& ends, const LinePoint& node) : ends_(ends), node_(node) {
    for (const RoadEnd& end : ends)
      if (end.line == lines_.size()) lines_.push_back(end.points.copy());
  }

  /// Whether the lines are others now.
  bool run() {
    std::vector<RoadExit> exits;
    for (const double flare : {kFlare, 0.0}) {
      exits.clear();
      for (std::size_t end = 0; end < ends_.size(); ++end)
        exits.push_back(find_exit(ends_, end, node_, flare));
      if (through_and_sides(exits)) return true;
    }
    if (std::count_if(exits.begin(), exits.end(), [](const RoadExit& e) { return e.directed; }) < 2)
      return false;
    join(crossing_of(exits, node_), exits, {});
    return true;
  }

  const LinePoint& node() const { return node_; }
  /// The lines in the direction of their first end.
  std::vector<std::vector<LinePoint>>& lines() { return lines_; }

 private:
  /// Joins the two roads that continue each other best by a curve and lets the others meet it;
  /// false, and nothing done, if there are no such two or the way to it is not known to be free.
  bool through_and_sides(const std::vector<RoadExit>& exits) {
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
    const FreeCircles circles = circles_around(exits);
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
      if (k != first && k != second &&
          !circles.free_between(exits[k].place, curve[nearest], kLeastClearance))
        return false;
    std::vector<std::vector<LinePoint>> ways(exits.size());
    for (std::size_t i = nearest; i-- > 1;) ways[first].push_back(curve[i]);
    for (std::size_t i = nearest + 1; i + 1 < curve.size(); ++i) ways[second].push_back(curve[i]);
    join(curve[nearest], exits, ways);
    return true;
  }

  /// Circles that are known to be free: the node's, and some along the lines up to the exits.
  FreeCircles circles_around(const std::vector<RoadExit>& exits) const {
    FreeCircles circles;
    circles.add(node_);
    for (const RoadExit& exit : exits) {
      const std::size_t step = exit.index / 8 + 1;
      for (std::size_t i = step; i < exit.index; i += step) circles.add(ends_[exit.end].points[i]);
      circles.add(exit.place);
    }
    return circles;
  }

  /// A cubic with the exits' places and directions, nearly an arc where these allow one; none if it
  /// leaves the circles.
  static std::vector<LinePoint> through_curve(const RoadExit& a, const RoadExit& b,
                                              const FreeCircles& circles) {
    constexpr int kParts = 32;
    const double turn = turn_between(a, b);
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
      place.distance = circles.known_distance(place);
      const double chord = s * a.place.distance + t * b.place.distance;
      if (place.distance < kLeastClearance * chord) return {};
      curve.push_back(place);
    }
    return curve;
  }

  /// Lets all lines start at `place` and go on to their exits, straight or by the way given.
  void join(const LinePoint& place, const std::vector<RoadExit>& exits,
            const std::vector<std::vector<LinePoint>>& ways) {
    std::vector<bool> seen(lines_.size(), false);
    for (std::size_t i = 0; i < exits.size(); ++i) {
      const RoadEnd& end = ends_[exits[i].end];
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

  std::vector<RoadEnd> ends_;
  LinePoint node_;
  std::vector<std::vector<LinePoint>> lines_;
};

/// The ends at a node; a line's end and its other one count as of one line.
std::vector<RoadEnd> ends_at(const LineNetwork& network, std::int32_t node,
                             std::span<const std::int32_t> lines) {
  std::vector<RoadEnd> ends;
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
