#pragma once

#include <vector>

#include "plugins/topology/line_network.hpp"

namespace stope::topology {

/// Averages each point with its neighbours along the line within `share` of its distance to the
/// obstacle, but at least `least_reach` cells, less towards the ends, which stay: takes away the
/// steps the raster leaves in obstacles' edges, and trembling that is small against the road.
std::vector<LinePoint> smooth_line(const std::vector<LinePoint>& points, double least_reach,
                                   double share);

/// Leaves out points that lie within `tolerance` cells of the line without them (Ramer 1972;
/// Douglas and Peucker 1973), and whose distance to the obstacle, drawn straight along it, is
/// within `tolerance` or `distance_share` of itself, whichever is more. No point is left out that
/// is more than a quarter of its distance to the obstacle off: so the line stays in free space
/// whatever the tolerance. Ends stay; a ring keeps at least two points between them.
std::vector<LinePoint> simplify_line(const std::vector<LinePoint>& points, double tolerance,
                                     double distance_share = 1e9);

}  // namespace stope::topology
