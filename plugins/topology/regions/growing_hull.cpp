#include "plugins/topology/regions/growing_hull.hpp"

#include <algorithm>
#include <tuple>

namespace stope::topology {

std::vector<HullPoint> convex_hull(std::vector<HullPoint> points) {
  std::sort(points.begin(), points.end(), [](const HullPoint& a, const HullPoint& b) {
    return std::tie(a.x, a.y) < std::tie(b.x, b.y);
  });
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<HullPoint> hull(2 * points.size());
  std::size_t count = 0;
  const auto push = [&](const HullPoint& point, std::size_t least) {
    while (count >= least && cross(hull[count - 2], hull[count - 1], point) <= 0) --count;
    hull[count++] = point;
  };
  for (const HullPoint& point : points) push(point, 2);
  const std::size_t lower = count + 1;
  for (std::size_t i = points.size() - 1; i-- > 0;) push(points[i], lower);
  hull.resize(count - 1);
  return hull;
}

void GrowingHull::start(std::span<const HullPoint> points) {
  corners_ = convex_hull({points.begin(), points.end()});
}

bool GrowingHull::see(const HullPoint& point, Addition& addition) const {
  const std::size_t count = corners_.size();
  if (count == 1) {
    addition = {{point, corners_[0], corners_[0]}, 0, 0};
    return !(point == corners_[0]);
  }
  if (count == 2 && cross(corners_[0], corners_[1], point) == 0) {
    const auto [low, high] = std::minmax(corners_[0], corners_[1], [](auto& a, auto& b) {
      return std::tie(a.x, a.y) < std::tie(b.x, b.y);
    });
    const bool below = std::tie(point.x, point.y) < std::tie(low.x, low.y);
    const bool above = std::tie(point.x, point.y) > std::tie(high.x, high.y);
    addition = {{point, corners_[0], corners_[1]}, 0, 0};
    return below || above;
  }
  const auto visible = [&](std::size_t side) {
    return cross(corners_[side], corners_[side + 1 < count ? side + 1 : 0], point) < 0;
  };
  // The visible sides follow each other around the hull: find one, then both ends of their run.
  std::size_t one = 0;
  while (one < count && !visible(one)) ++one;
  if (one == count) return false;
  std::size_t first = one, sides = 1;
  while (sides < count && visible((first + count - 1) % count)) {
    first = (first + count - 1) % count;
    ++sides;
  }
  while (sides < count && visible((first + sides) % count)) ++sides;
  // Seen from the point, the run of visible sides goes clockwise.
  addition = {{point, corners_[(first + sides) % count], corners_[first]}, first, sides};
  return true;
}

void GrowingHull::add(const HullPoint& point, const Addition& addition) {
  if (addition.count == 0) {  // still a point or a straight line
    corners_.push_back(point);
    corners_ = convex_hull(corners_);
    return;
  }
  const std::size_t count = corners_.size();
  // The corners between the visible sides go; the point takes their place.
  std::vector<HullPoint>& corners = corners_;
  std::rotate(corners.begin(), corners.begin() + static_cast<std::ptrdiff_t>(addition.first),
              corners.end());
  const auto gone = static_cast<std::ptrdiff_t>(addition.count) - 1;
  corners.erase(
      corners.begin() + 1,
      corners.begin() + 1 + std::min<std::ptrdiff_t>(gone, static_cast<std::ptrdiff_t>(count) - 1));
  corners.insert(corners.begin() + 1, point);
}

}  // namespace stope::topology
