// Problem: a way over cells has the corners of cells.
// Idea: from point to point, each time to one as far ahead as is seen; then the same with points
// between, so that lines may begin and end anywhere on the way.
// Cost: a few rounds of O(points) lines of sight.
#include "plugins/planner/pulled_straight.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace stope::planner {
namespace {

/// Whether a line from one point of a chain to a later one may take the place of what is between.
bool straight(ShortcutGround& ground, const std::vector<Vector2>& points,
              const std::vector<double>& until, std::size_t from, std::size_t to) {
  const auto cost = ground.cost_of_sight(points[from], points[to]);
  return cost && *cost <= until[to] - until[from] + 1e-9 * until.back();
}

std::vector<Vector2> pulled(ShortcutGround& ground, const std::vector<Vector2>& points) {
  std::vector<double> until{0};
  for (std::size_t i = 1; i < points.size(); ++i) {
    // A piece of a chain may be driven already, so it is seen.
    const auto cost = ground.roads().slow() ? ground.cost_of_sight(points[i - 1], points[i])
                                            : std::optional((points[i] - points[i - 1]).norm());
    until.push_back(until.back() + cost.value_or((points[i] - points[i - 1]).norm()));
  }
  std::vector<Vector2> kept{points.front()};
  for (std::size_t i = 0; i + 1 < points.size();) {
    // Twice as far while it sees, then half as far until it is one point.
    std::size_t reached = i + 1, stride = 1;
    const auto sees = [&] {
      return reached + stride < points.size() &&
             straight(ground, points, until, i, reached + stride);
    };
    while (sees()) reached += stride, stride *= 2;
    for (; stride > 0; stride /= 2)
      if (sees()) reached += stride;
    kept.push_back(points[reached]);
    i = reached;
  }
  return kept;
}

/// Points of the same lines, about `apart` metres from each other.
std::vector<Vector2> divided(const std::vector<Vector2>& points, double apart) {
  std::vector<Vector2> all{points.front()};
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Vector2 way = points[i] - points[i - 1];
    const auto count = std::max(1.0, std::ceil(way.norm() / apart));
    for (double k = 1; k < count; ++k) all.push_back(points[i - 1] + (k / count) * way);
    all.push_back(points[i]);
  }
  return all;
}

}  // namespace

std::vector<Vector2> pulled_straight(ShortcutGround& ground, std::vector<Vector2> points) {
  constexpr int kRounds = 4;
  points = pulled(ground, points);
  for (int round = 0; round < kRounds && points.size() > 2; ++round)
    points = pulled(ground, divided(points, ground.frame().resolution));
  return points;
}

}  // namespace stope::planner
