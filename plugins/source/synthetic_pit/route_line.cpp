#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "plugins/source/synthetic_pit/curve.hpp"
#include "plugins/source/synthetic_pit/route.hpp"

namespace stope::source {
namespace {

constexpr double kPi = std::numbers::pi;

std::vector<Vector2> leg_points(const NetworkGraph& graph, const Leg& leg) {
  std::vector<Vector2> points = graph.edges[leg.edge].points;
  if (leg.backward) std::reverse(points.begin(), points.end());
  return points;
}

Vector2 start_direction(const std::vector<Vector2>& line) {
  return (line[std::min<std::size_t>(2, line.size() - 1)] - line.front()).normalized();
}

Vector2 end_direction(const std::vector<Vector2>& line) {
  return (line.back() - line[line.size() - 1 - std::min<std::size_t>(2, line.size() - 1)])
      .normalized();
}

/// What is left of a line when `head` and `tail` metres are cut off its ends.
std::vector<Vector2> trim(const std::vector<Vector2>& line, double head, double tail) {
  const std::vector<double> station = stations(line);
  const auto at = [&](double s) {
    std::size_t i = 0;
    while (i + 2 < line.size() && station[i + 1] < s) ++i;
    const double t = (s - station[i]) / (station[i + 1] - station[i]);
    return Vector2(line[i] + t * (line[i + 1] - line[i]));
  };
  const double end = station.back() - tail;
  std::vector<Vector2> rest{at(head)};
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (station[i] > head + 0.2 && station[i] < end - 0.2) rest.push_back(line[i]);
  }
  rest.push_back(at(end));
  return rest;
}

void add_arc(std::vector<Vector2>& line, const Vector2& centre, double radius, double from,
             double turn) {
  const int count = std::max(2, static_cast<int>(std::ceil(std::abs(turn) * radius / kRouteStep)));
  for (int i = 1; i <= count; ++i) {
    const double angle = from + turn * i / count;
    line.push_back(centre + radius * Vector2(std::cos(angle), std::sin(angle)));
  }
}

/// A place on the way with the direction of travel.
struct Waypoint {
  Vector2 place, ahead;
};

/// From one waypoint to another by a cubic curve, which between the ends of a circle's arc is all
/// but the arc.
void add_bend(std::vector<Vector2>& line, const Waypoint& from, const Waypoint& to) {
  const double chord = (to.place - from.place).norm();
  if (chord < 0.2) return;
  const double turn = std::acos(std::clamp(from.ahead.dot(to.ahead), -1.0, 1.0));
  const double speed =
      turn < 0.01 ? chord : 2 * chord * std::tan(0.25 * turn) / std::sin(0.5 * turn);
  const int count = std::max(2, static_cast<int>(std::ceil(1.2 * chord / kRouteStep)));
  for (int i = 1; i <= count; ++i) {
    const double t = static_cast<double>(i) / count, u = 1 - t;
    line.push_back(u * u * (1 + 2 * t) * from.place + t * t * (3 - 2 * t) * to.place +
                   speed * u * t * (u * from.ahead - t * to.ahead));
  }
}

Waypoint arrival_at(const std::vector<Vector2>& line, double tail) {
  const std::vector<Vector2> rest = trim(line, 0, tail);
  return {rest.back(), end_direction(rest)};
}

Waypoint departure(const std::vector<Vector2>& line, double head) {
  const std::vector<Vector2> rest = trim(line, head, 0);
  return {rest.front(), start_direction(rest)};
}

/// How much of two roads is cut off to go from one to the other.
struct Corner {
  double tail = 0, head = 0;
};

/// Roads bend on their way into a junction, so that the cuts that would suit straight ones need not
/// be best: tries some around them for the widest bend.
Corner widest_corner(const std::vector<Vector2>& in, const std::vector<Vector2>& out, double radius,
                     double room) {
  const double turn = std::acos(std::clamp(end_direction(in).dot(start_direction(out)), -1.0, 1.0));
  const double cut = std::min(radius * std::tan(0.5 * turn), room);
  Corner best{cut, cut};
  if (cut < 2) return best;
  double widest = 0;
  for (const double tail : {1.0, 0.7, 0.85, 1.15, 1.3}) {
    for (const double head : {1.0, 0.7, 0.85, 1.15, 1.3}) {
      const Corner corner{std::min(tail * cut, room), std::min(head * cut, room)};
      const Waypoint from = arrival_at(in, corner.tail);
      std::vector<Vector2> bend{from.place};
      add_bend(bend, from, departure(out, corner.head));
      const double smallest = smallest_radius(bend, false, 2);
      if (smallest > widest) widest = smallest, best = corner;
    }
  }
  return best;
}

/// Out of a turning place: a little to the right, round the middle to the left, a little to the
/// right again, all with the same radius, back to where it began.
void add_turn_round(std::vector<Vector2>& line, const Waypoint& arrival, const Vector2& middle,
                    const Vector2& heading) {
  const double radius = kTurningRadius, ahead = std::atan2(heading.y(), heading.x());
  const Vector2 right(heading.y(), -heading.x());
  const Vector2 start = middle - std::sqrt(3.0) * radius * heading;
  add_bend(line, arrival, {start, heading});
  add_arc(line, start + radius * right, radius, ahead + kPi / 2, -kPi / 3);
  add_arc(line, middle, radius, ahead - 5 * kPi / 6, 5 * kPi / 3);
  add_arc(line, start - radius * right, radius, ahead - kPi / 6, -kPi / 3);
  add_bend(line, {start, -heading}, {arrival.place, -arrival.ahead});
}

std::vector<Vector2> even_steps(const std::vector<Vector2>& line) {
  const std::vector<double> station = stations(line);
  const auto count = static_cast<std::size_t>(station.back() / kRouteStep);
  std::vector<Vector2> points;
  std::size_t i = 0;
  for (std::size_t k = 0; k <= count; ++k) {
    const double s = kRouteStep * static_cast<double>(k);
    while (i + 2 < line.size() && station[i + 1] < s) ++i;
    const double leg = station[i + 1] - station[i];
    const double t = leg > 0 ? (s - station[i]) / leg : 0;
    points.push_back(line[i] + t * (line[i + 1] - line[i]));
  }
  return points;
}

std::vector<Vector2> smoothed(const std::vector<Vector2>& line) {
  std::vector<double> x, y;
  for (const Vector2& point : line) {
    x.push_back(point.x());
    y.push_back(point.y());
  }
  // Three times over about 6 m: curvature changes along a clothoid's length instead of at once.
  for (int pass = 0; pass < 3; ++pass) {
    x = moving_average(x, 6);
    y = moving_average(y, 6);
  }
  std::vector<Vector2> points;
  for (std::size_t i = 0; i < x.size(); ++i) points.emplace_back(x[i], y[i]);
  return points;
}

}  // namespace

std::vector<Vector2> route_line(const StreetNetwork& network, const NetworkGraph& graph,
                                const std::vector<Leg>& legs, const NetworkRules& rules,
                                const Checkpoint& checkpoint) {
  std::vector<Vector2> line;
  double head = 0;
  const double loop = std::sqrt(3.0) * kTurningRadius;
  // What of an edge may be cut off at a corner: less than half, and not what turning round needs.
  const auto room = [&](const Leg& leg) {
    const auto& edge = graph.edges[leg.edge];
    const double length = stations(edge.points).back();
    const bool ends = graph.nodes[edge.from].dead_end || graph.nodes[edge.to].dead_end;
    return std::max(1.0, std::min(0.45 * length, ends ? length - loop - 4 : length));
  };
  for (std::size_t k = 0; k < legs.size(); ++k) {
    checkpoint();
    const std::vector<Vector2> points = leg_points(graph, legs[k]);
    if (k + 1 == legs.size()) {
      const std::vector<Vector2> rest = trim(points, head, 0);
      line.insert(line.end(), rest.begin(), rest.end());
      break;
    }
    const auto& edge = graph.edges[legs[k].edge];
    const auto& node = graph.nodes[legs[k].backward ? edge.from : edge.to];
    const std::vector<Vector2> following = leg_points(graph, legs[k + 1]);
    const double length = stations(points).back();
    const bool turns_round = legs[k].edge == legs[k + 1].edge && node.dead_end;
    double tail = 0, next_head = 0;
    if (turns_round) {
      // The loop begins on the turning place's axis; a stretch before it leads there.
      next_head = tail = std::max(loop, std::min(loop + 14, 0.5 * length));
    } else {
      const double radius = std::max(kTurningRadius + 2, 0.5 * edge.width + rules.fillet - 1);
      const Corner corner =
          widest_corner(points, following, radius, std::min(room(legs[k]), room(legs[k + 1])));
      tail = corner.tail;
      next_head = corner.head;
    }
    const std::vector<Vector2> rest = trim(points, head, tail);
    line.insert(line.end(), rest.begin(), rest.end());
    const Waypoint arrival{rest.back(), end_direction(rest)};
    if (turns_round) {
      add_turn_round(line, arrival, node.place, network.heading(network.dead_ends[*node.dead_end]));
    } else {
      add_bend(line, arrival, departure(following, next_head));
    }
    head = next_head;
  }
  return smoothed(even_steps(line));
}

}  // namespace stope::source
