#pragma once

#include <cstddef>
#include <vector>

#include "plugins/topology/line_network.hpp"

namespace stope::topology {

/// One end of a line at a junction.
struct RoadEnd {
  CourseView points;     ///< from the junction on
  double length = 0;     ///< of the line
  std::size_t line = 0;  ///< among those of the junction
};

/// How a road leaves a junction: from where on it is itself again, and how it goes on from there.
struct RoadExit {
  std::size_t end = 0;    ///< among those of the junction
  std::size_t index = 0;  ///< of the place along the line, from the junction
  LinePoint place;
  double dx = 0, dy = 0;  ///< direction outwards at the place
  double curvature = 0;   ///< there, of the way outwards; to the left is positive
  bool directed = false;  ///< the road is long enough to have a direction
};

/// Where a road leaves the junction `node`: where it is about as narrow as it gets within `flare`
/// radii of the node's circle, but at the earliest on the circle's rim, and within the near half of
/// the line. Direction and curvature are those of a parabola laid through the road beyond.
RoadExit find_exit(const std::vector<RoadEnd>& ends, std::size_t end, const LinePoint& node,
                   double flare);

/// How far a road turns that comes in by one exit and leaves by the other: 0 to pi radians.
double turn_between(const RoadExit& a, const RoadExit& b);

/// How badly two roads continue each other: what is left of the turn from one to the other when
/// their own curvature has made its part, and how far that turn is from an arc's; radians.
double mismatch(const RoadExit& a, const RoadExit& b);

/// How far a point is off the road's own continuation into the junction, drawn as a parabola of
/// `share` of its curvature; to the left of the way outwards is positive.
double distance_to_continuation(const LinePoint& point, const RoadExit& exit, double share);

/// The place that is nearest to the straight continuations of all exits that have a direction, in
/// the sense of least squares, and not farther from `node` than half of its circle.
LinePoint crossing_of(const std::vector<RoadExit>& exits, const LinePoint& node);

}  // namespace stope::topology
