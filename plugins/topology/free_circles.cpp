#include "plugins/topology/free_circles.hpp"

#include <algorithm>

namespace stope::topology {

double FreeCircles::known_distance(const LinePoint& place) const {
  double known = 0;
  for (const LinePoint& circle : circles_)
    known = std::max(known, circle.distance - distance_between(place, circle));
  return known;
}

bool FreeCircles::free_between(const LinePoint& a, const LinePoint& b, double share) const {
  constexpr int kParts = 16;
  const double least = share * std::min(a.distance, b.distance);
  for (int i = 1; i < kParts; ++i) {
    const double part = static_cast<double>(i) / kParts;
    const LinePoint place{a.x + part * (b.x - a.x), a.y + part * (b.y - a.y), 0};
    if (known_distance(place) < least) return false;
  }
  return true;
}

}  // namespace stope::topology
