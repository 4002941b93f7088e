#include "plugins/topology/regions/convex_hull.hpp"

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

}  // namespace stope::topology
