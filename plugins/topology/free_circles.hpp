#pragma once

#include <vector>

#include "plugins/topology/line_network.hpp"

namespace stope::topology {

/// Circles around places whose distance to the nearest obstacle is known: within their union a line
/// can be moved without looking at the map.
class FreeCircles {
 public:
  void add(const LinePoint& place) { circles_.push_back(place); }

  /// A lower bound of the distance from a place to the nearest obstacle; 0 outside of all circles.
  double known_distance(const LinePoint& place) const;
  /// Whether a straight line has, at sixteen places, `share` of the lesser distance of its ends.
  bool free_between(const LinePoint& a, const LinePoint& b, double share) const;

 private:
  std::vector<LinePoint> circles_;
};

}  // namespace stope::topology
