#include "plugins/source/synthetic_pit/curve.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace stope::source {
namespace {

Vector2 spline_point(const Vector2& a, const Vector2& b, const Vector2& c, const Vector2& d,
                     double t) {
  const double u = 1 - t;
  return (u * u * u * a + (3 * t * t * t - 6 * t * t + 4) * b +
          (-3 * t * t * t + 3 * t * t + 3 * t + 1) * c + t * t * t * d) /
         6.0;
}

std::vector<Vector2> resample(std::span<const Vector2> dense, bool closed, double step) {
  std::vector<Vector2> line(dense.begin(), dense.end());
  if (closed) line.push_back(line.front());
  const std::vector<double> station = stations(line);
  const double length = station.back();
  const auto count = std::max<std::size_t>(2, static_cast<std::size_t>(std::ceil(length / step)));
  std::vector<Vector2> points;
  std::size_t i = 0;
  for (std::size_t k = 0; k <= count; ++k) {
    const double s = length * static_cast<double>(k) / static_cast<double>(count);
    while (i + 2 < line.size() && station[i + 1] < s) ++i;
    const double leg = station[i + 1] - station[i];
    const double t = leg > 0 ? (s - station[i]) / leg : 0;
    points.push_back(line[i] + t * (line[i + 1] - line[i]));
  }
  if (closed) points.pop_back();
  return points;
}

}  // namespace

std::vector<Vector2> smooth_curve(std::span<const Vector2> controls, bool closed, double step) {
  std::vector<Vector2> padded;
  const std::size_t n = controls.size();
  if (closed) {
    padded.push_back(controls[n - 1]);
    padded.insert(padded.end(), controls.begin(), controls.end());
    padded.push_back(controls[0]);
    padded.push_back(controls[1 % n]);
  } else {
    padded.push_back(2 * controls[0] - controls[1]);
    padded.insert(padded.end(), controls.begin(), controls.end());
    padded.push_back(2 * controls[n - 1] - controls[n - 2]);
  }
  constexpr int kSamples = 24;
  std::vector<Vector2> dense;
  for (std::size_t i = 0; i + 3 < padded.size(); ++i) {
    for (int k = 0; k < kSamples; ++k) {
      dense.push_back(spline_point(padded[i], padded[i + 1], padded[i + 2], padded[i + 3],
                                   static_cast<double>(k) / kSamples));
    }
  }
  if (!closed) dense.push_back(controls.back());
  return resample(dense, closed, step);
}

double smallest_radius(std::span<const Vector2> points, bool closed, std::size_t reach) {
  const std::size_t n = points.size();
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < n; ++i) {
    if (!closed && (i < reach || i + reach >= n)) continue;
    const Vector2& a = points[(i + n - reach) % n];
    const Vector2& b = points[i];
    const Vector2& c = points[(i + reach) % n];
    const Vector2 ab = b - a, bc = c - b, ac = c - a;
    const double twice_area = std::abs(ab.x() * bc.y() - ab.y() * bc.x());
    if (twice_area < 1e-9) continue;
    smallest = std::min(smallest, ab.norm() * bc.norm() * ac.norm() / (2 * twice_area));
  }
  return smallest;
}

std::vector<double> stations(std::span<const Vector2> points) {
  std::vector<double> station(points.size(), 0.0);
  for (std::size_t i = 1; i < points.size(); ++i)
    station[i] = station[i - 1] + (points[i] - points[i - 1]).norm();
  return station;
}

std::vector<double> moving_average(std::span<const double> values, std::size_t half) {
  std::vector<double> sums(values.size() + 1, 0.0);
  for (std::size_t i = 0; i < values.size(); ++i) sums[i + 1] = sums[i] + values[i];
  std::vector<double> means(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    // The window shrinks evenly towards the ends, so that end values stay as they are.
    const std::size_t reach = std::min({half, i, values.size() - 1 - i});
    means[i] = (sums[i + reach + 1] - sums[i - reach]) / static_cast<double>(2 * reach + 1);
  }
  return means;
}

}  // namespace stope::source
