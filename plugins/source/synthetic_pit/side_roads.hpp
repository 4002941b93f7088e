#pragma once

#include <functional>

#include "plugins/source/synthetic_pit/layout.hpp"
#include "stope/random.hpp"

namespace stope::source {

/// Where a side road leaves another street, and how.
struct SideRoadPlan {
  std::size_t through = 0;
  std::size_t point = 0;
  double side = 1;      ///< 1: to the left of the street's direction, -1: to the right
  double length = 80;   ///< metres
  double lean = 0;      ///< radians the road turns in all, after it has left at a right angle
  double wobble = 0.2;  ///< radians, of random turns
};

/// A side road that ends in a turning place. Its elevations are those of its start.
Proposal side_road(const Layout& layout, const SideRoadPlan& plan, const DeadEnd& dead_end,
                   Random& random);

/// A road between a point of one street and a point of another, leaving both at right angles on the
/// given sides. Its elevations go evenly from one to the other between level ends.
Proposal connecting_road(const Layout& layout, const SideRoadPlan& from, const SideRoadPlan& to,
                         Random& random);

}  // namespace stope::source
