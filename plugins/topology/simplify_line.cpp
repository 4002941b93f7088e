#include "plugins/topology/simplify_line.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace stope::topology {
namespace {

constexpr double kMostOfCircle = 0.25;  // that a simplified line may be off

/// How far a point is off the stretch from a to b, and its distance off what is drawn along it.
struct Offset {
  double place = 0, distance = 0;
};

Offset offset_from(const LinePoint& point, const LinePoint& a, const LinePoint& b) {
  const double dx = b.x - a.x, dy = b.y - a.y;
  const double squared = dx * dx + dy * dy;
  double part = 0;
  if (squared > 0)
    part = std::clamp(((point.x - a.x) * dx + (point.y - a.y) * dy) / squared, 0.0, 1.0);
  return {distance_between(point, {a.x + part * dx, a.y + part * dy, 0}),
          std::abs(a.distance + part * (b.distance - a.distance) - point.distance)};
}

}  // namespace

std::vector<LinePoint> smooth_line(const std::vector<LinePoint>& points, double least_reach,
                                   double share) {
  std::vector<double> way(points.size(), 0);
  std::vector<LinePoint> sum(points.size() + 1);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0) way[i] = way[i - 1] + distance_between(points[i - 1], points[i]);
    sum[i + 1] = {sum[i].x + points[i].x, sum[i].y + points[i].y,
                  sum[i].distance + points[i].distance};
  }
  std::vector<LinePoint> result = points;
  // Both ends of the stretch that is averaged move little from point to point.
  std::size_t begin = 0, end = 0;
  for (std::size_t i = 1; i + 1 < points.size(); ++i) {
    const double reach =
        std::min({std::max(least_reach, share * points[i].distance), way[i], way.back() - way[i]});
    while (begin > 0 && way[begin - 1] >= way[i] - reach) --begin;
    while (way[begin] < way[i] - reach) ++begin;
    while (end > 0 && way[end - 1] > way[i] + reach) --end;
    while (end < way.size() && way[end] <= way[i] + reach) ++end;
    const LinePoint &from = sum[begin], &to = sum[end];
    const auto count = static_cast<double>(end - begin);
    result[i] = {(to.x - from.x) / count, (to.y - from.y) / count,
                 (to.distance - from.distance) / count};
  }
  return result;
}

std::vector<LinePoint> simplify_line(const std::vector<LinePoint>& points, double tolerance,
                                     double distance_share) {
  if (points.size() <= 2) return points;
  std::vector<bool> kept(points.size(), false);
  kept.front() = kept.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> open{{0, points.size() - 1}};
  while (!open.empty()) {
    const auto [first, last] = open.back();
    open.pop_back();
    bool is_off = false;
    double largest = -1, most_excess = 0;
    std::size_t farthest = first, worst = first;
    for (std::size_t i = first + 1; i < last; ++i) {
      const Offset off = offset_from(points[i], points[first], points[last]);
      // So much of its free circle is left that what is drawn is free along all of its length.
      const double most = std::min(tolerance, kMostOfCircle * points[i].distance);
      if (off.place > most) is_off = true;
      if (off.place > largest) largest = off.place, farthest = i;
      const double excess = off.distance - std::max(tolerance, distance_share * points[i].distance);
      if (excess > most_excess) most_excess = excess, worst = i;
    }
    const bool closed = first == 0 && last + 1 == points.size() &&
                        distance_between(points[first], points[last]) == 0;
    if (farthest == first) continue;
    if (!is_off && !closed) {
      if (worst == first) continue;
      farthest = worst;
    }
    kept[farthest] = true;
    open.emplace_back(first, farthest);
    open.emplace_back(farthest, last);
  }
  std::vector<LinePoint> result;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (kept[i]) result.push_back(points[i]);
  return result;
}

}  // namespace stope::topology
