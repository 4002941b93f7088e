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

/// Out of a turning place: a little to the right, round the middle to the left, a little to the
/// right again, back on the line of arrival, all with the same radius.
void add_turn_round(std::vector<Vector2>& line, const Vector2& middle, const Vector2& heading) {
  const double radius = kTurningRadius, ahead = std::atan2(heading.y(), heading.x());
  const Vector2 right(heading.y(), -heading.x());
  const Vector2 start = middle - std::sqrt(3.0) * radius * heading;
  add_arc(line, start + radius * right, radius, ahead + kPi / 2, -kPi / 3);
  add_arc(line, middle, radius, ahead - 5 * kPi / 6, 5 * kPi / 3);
  add_arc(line, start - radius * right, radius, ahead - kPi / 6, -kPi / 3);
}

double corner_cut(const Vector2& in, const Vector2& out, double radius, double room) {
  const double turn = std::acos(std::clamp(in.dot(out), -1.0, 1.0));
  return std::min(radius * std::tan(0.5 * turn), room);
}

/// A circle arc from one direction to another, around a corner both are `cut` metres away from.
void add_corner(std::vector<Vector2>& line, const Vector2& corner, const Vector2& in,
                const Vector2& out, double cut) {
  const double cross = in.x() * out.y() - in.y() * out.x();
  const double turn = std::atan2(cross, in.dot(out));
  if (std::abs(turn) < 0.05) return;
  const double radius = cut / std::tan(0.5 * std::abs(turn)), side = turn > 0 ? 1 : -1;
  const Vector2 left(-in.y(), in.x());
  const Vector2 centre = corner - cut * in + side * radius * left;
  const Vector2 spoke = -side * left;
  add_arc(line, centre, radius, std::atan2(spoke.y(), spoke.x()), turn);
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
  // Twice over about 4 m: curvature changes along a clothoid's length instead of at once.
  for (int pass = 0; pass < 2; ++pass) {
    x = moving_average(x, 4);
    y = moving_average(y, 4);
  }
  std::vector<Vector2> points;
  for (std::size_t i = 0; i < x.size(); ++i) points.emplace_back(x[i], y[i]);
  return points;
}

}  // namespace

std::vector<Vector2> route_line(const StreetNetwork& network, const NetworkGraph& graph,
                                const std::vector<Leg>& legs, const NetworkRules& rules) {
  std::vector<Vector2> line;
  double head = 0;
  for (std::size_t k = 0; k < legs.size(); ++k) {
    const std::vector<Vector2> points = leg_points(graph, legs[k]);
    if (k + 1 == legs.size()) {
      const std::vector<Vector2> rest = trim(points, head, 0);
      line.insert(line.end(), rest.begin(), rest.end());
      break;
    }
    const auto& edge = graph.edges[legs[k].edge];
    const auto& node = graph.nodes[legs[k].backward ? edge.from : edge.to];
    const bool turns_round = legs[k].edge == legs[k + 1].edge && node.dead_end;
    const std::vector<Vector2> following = leg_points(graph, legs[k + 1]);
    const std::size_t n = points.size();
    const std::size_t reach = std::min<std::size_t>({6, n - 1, following.size() - 1});
    const Vector2 in = (points[n - 1] - points[n - 1 - reach]).normalized();
    const Vector2 out = (following[reach] - following[0]).normalized();
    const double room = 0.45 * std::min(stations(points).back(), stations(following).back());
    const double radius = std::max(kTurningRadius, 0.5 * edge.width + rules.fillet - 2);
    const double tail =
        turns_round ? std::sqrt(3.0) * kTurningRadius : corner_cut(in, out, radius, room);
    const std::vector<Vector2> rest = trim(points, head, tail);
    line.insert(line.end(), rest.begin(), rest.end());
    if (turns_round) {
      add_turn_round(line, node.place, network.heading(network.dead_ends[*node.dead_end]));
    } else {
      add_corner(line, node.place, in, out, tail);
    }
    head = tail;
  }
  return smoothed(even_steps(line));
}

}  // namespace stope::source
