#include "plugins/planner/route_line.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "stope/error.hpp"

namespace stope::planner {

RouteLine::RouteLine(const Path& path) {
  for (std::size_t i = 0; i < path.points.size(); ++i) {
    const Vector2 point(path.points[i].x, path.points[i].y);
    if (!std::isfinite(point.x()) || !std::isfinite(point.y()) ||
        std::max(std::abs(point.x()), std::abs(point.y())) > 1e9) {
      throw Error(fmt::format(
          "point {} of the path is ({}, {}), which is no place: the path must be in metres of the "
          "map's frame",
          i, point.x(), point.y()));
    }
    if (!points_.empty() && (point - points_.back()).norm() < 1e-6) continue;
    along_.push_back(points_.empty() ? 0 : along_.back() + (point - points_.back()).norm());
    points_.push_back(point);
  }
  if (path.points.empty())
    throw Error("the path has no points, so there is nothing to drive: plan a path first");
  if (points_.size() < 2) {
    throw Error(fmt::format(
        "the path has no length: {} of its points lie at ({:.2f}, {:.2f}); start and goal must be "
        "different places",
        path.points.size() == 1 ? "the only one" : "all", points_[0].x(), points_[0].y()));
  }
}

RouteLine RouteLine::until(double along) const {
  RouteLine line;
  for (std::size_t i = 0; i < points_.size() && (i == 0 || along_[i] < along - 1e-6); ++i) {
    line.points_.push_back(points_[i]);
    line.along_.push_back(along_[i]);
  }
  line.points_.push_back(at(along));
  line.along_.push_back(along);
  return line;
}

std::size_t RouteLine::segment(double along) const {
  // Points mostly lie evenly: where this one would lie then, and a few beside.
  const std::size_t last = points_.size() - 1;
  const double share = std::clamp(along / along_.back(), 0.0, 1.0);
  auto i = std::clamp<std::size_t>(static_cast<std::size_t>(share * static_cast<double>(last)) + 1,
                                   1, last);
  for (int tries = 0; tries < 4; ++tries) {
    if (i > 1 && along_[i - 1] > along)
      --i;
    else if (i < last && along_[i] <= along)
      ++i;
    else
      return i;
  }
  const auto after = std::upper_bound(along_.begin(), along_.end(), along) - along_.begin();
  return static_cast<std::size_t>(
      std::clamp<std::ptrdiff_t>(after, 1, static_cast<std::ptrdiff_t>(last)));
}

Vector2 RouteLine::at(double along) const {
  const std::size_t i = segment(along);
  const double share = std::clamp((along - along_[i - 1]) / (along_[i] - along_[i - 1]), 0.0, 1.0);
  return points_[i - 1] + share * (points_[i] - points_[i - 1]);
}

double RouteLine::heading(double along, double ahead) const {
  const double to = std::min(length(), along + ahead);
  const Vector2 way = at(to) - at(std::min(along, to - std::min(ahead, length())));
  if (way.norm() > 1e-6) return std::atan2(way.y(), way.x());
  const std::size_t i = segment(along);
  const Vector2 step = points_[i] - points_[i - 1];
  return std::atan2(step.y(), step.x());
}

double RouteLine::nearest(const Vector2& point, double from, double to) const {
  const Vector2 first = at(from);
  double best = from, least = (first - point).squaredNorm();
  const std::size_t last = segment(to);
  for (std::size_t i = segment(from); i <= last; ++i) {
    const Vector2 step = points_[i] - points_[i - 1], off = point - points_[i - 1];
    const double length = along_[i] - along_[i - 1];
    const double low = std::max(0.0, (from - along_[i - 1]) / length);
    const double high = std::min(1.0, (to - along_[i - 1]) / length);
    const double share = std::clamp(step.dot(off) / (length * length), low, high);
    const double distance = (off - share * step).squaredNorm();
    if (distance < least) least = distance, best = along_[i - 1] + share * length;
  }
  return best;
}

RouteLine RouteLine::between(double from, double to) const {
  RouteLine line;
  line.points_.push_back(at(from));
  line.along_.push_back(0);
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (along_[i] <= from + 1e-6 || along_[i] >= to - 1e-6) continue;
    line.points_.push_back(points_[i]);
    line.along_.push_back(along_[i] - from);
  }
  line.points_.push_back(at(to));
  line.along_.push_back(to - from);
  return line;
}

MapBox RouteLine::box() const {
  MapBox box{points_[0].x(), points_[0].y(), points_[0].x(), points_[0].y()};
  for (const Vector2& point : points_) {
    box.left = std::min(box.left, point.x()), box.right = std::max(box.right, point.x());
    box.bottom = std::min(box.bottom, point.y()), box.top = std::max(box.top, point.y());
  }
  return box;
}

std::vector<Vector2> RouteLine::places(double apart) const {
  const double count = std::ceil(length() / apart);
  std::vector<Vector2> places;
  for (double i = 0; i <= count; ++i) places.push_back(at(length() * i / count));
  return places;
}

}  // namespace stope::planner
