#include "plugins/topology/regions/convex_hull.hpp"

#include <algorithm>
#include <iterator>
#include <tuple>
#include <utility>

namespace stope::topology {
namespace {

bool is_left_of(const HullPoint& a, const HullPoint& b) {
  return std::tie(a.x, a.y) < std::tie(b.x, b.y);
}

std::vector<HullPoint> hull_of_sorted(std::vector<HullPoint> points) {
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

/// From the lowest left corner a hull leads up to the highest right one, and from there back.
std::vector<HullPoint> sorted_corners(const std::vector<HullPoint>& hull) {
  std::vector<HullPoint> sorted(hull.size());
  const auto turn = std::max_element(hull.begin(), hull.end(), is_left_of);
  std::merge(hull.begin(), turn, hull.rbegin(), std::make_reverse_iterator(turn), sorted.begin(),
             is_left_of);
  return sorted;
}

}  // namespace

std::vector<HullPoint> convex_hull(std::vector<HullPoint> points) {
  std::sort(points.begin(), points.end(), is_left_of);
  return hull_of_sorted(std::move(points));
}

std::vector<HullPoint> joined_hull(const std::vector<HullPoint>& a,
                                   const std::vector<HullPoint>& b) {
  const std::vector<HullPoint> first = sorted_corners(a), second = sorted_corners(b);
  std::vector<HullPoint> all(a.size() + b.size());
  std::merge(first.begin(), first.end(), second.begin(), second.end(), all.begin(), is_left_of);
  return hull_of_sorted(std::move(all));
}

}  // namespace stope::topology
