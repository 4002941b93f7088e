#include "framework/report/draw/simplify.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "framework/report/draw/grid_picture.hpp"

namespace stope::report {
namespace {

double distance_to_segment(const Vector2& point, const Vector2& a, const Vector2& b) {
  const Vector2 along = b - a;
  const double length = along.squaredNorm();
  const double part = length > 0 ? std::clamp((point - a).dot(along) / length, 0.0, 1.0) : 0.0;
  return (point - a - part * along).norm();
}

bool is_finite(const Vector2& point) {
  return std::isfinite(point.x()) && std::isfinite(point.y());
}

}  // namespace

std::vector<Vector2> simplified(std::vector<Vector2> line, double tolerance) {
  line.erase(std::remove_if(line.begin(), line.end(), [](const auto& p) { return !is_finite(p); }),
             line.end());
  if (line.size() < 3) return line;
  std::vector<bool> keep(line.size(), false);
  keep.front() = keep.back() = true;
  std::vector<std::pair<std::size_t, std::size_t>> todo{{0, line.size() - 1}};
  while (!todo.empty()) {
    const auto [first, last] = todo.back();
    todo.pop_back();
    double worst = tolerance;
    std::size_t place = first;
    for (std::size_t i = first + 1; i < last; ++i) {
      const double distance = distance_to_segment(line[i], line[first], line[last]);
      if (distance > worst) worst = distance, place = i;
    }
    if (place == first) continue;
    keep[place] = true;
    todo.emplace_back(first, place);
    todo.emplace_back(place, last);
  }
  std::vector<Vector2> kept;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (keep[i]) kept.push_back(line[i]);
  }
  return kept;
}

double half_a_pixel(const std::vector<Vector2>& points) {
  Vector2 low(0, 0), high(0, 0);
  bool first = true;
  for (const Vector2& point : points) {
    if (!is_finite(point)) continue;
    low = first ? point : Vector2(low.cwiseMin(point));
    high = first ? point : Vector2(high.cwiseMax(point));
    first = false;
  }
  return (high - low).maxCoeff() / (2.0 * kLongestSide);
}

}  // namespace stope::report
