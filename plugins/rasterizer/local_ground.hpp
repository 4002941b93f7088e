#pragma once

#include <vector>

#include "stope/context.hpp"
#include "stope/payloads/grid_frame.hpp"
#include "stope/payloads/point_cloud.hpp"

namespace stope::rasterizer {

/// How the height of the ground is told from points.
struct GroundRules {
  double cell = 0.5;       ///< metres, edge of the cells the ground is told in
  double radius = 3;       ///< metres, how far round a cell one looks
  double quantile = 0.25;  ///< of the low points round a cell, 0 the lowest
};

/// The ground's height in each cell, NaN where nothing is known of it; heights are relative to the
/// cloud's origin, as the points.
struct LocalGround {
  GridFrame frame;  ///< axis-aligned, in the map frame
  std::vector<float> height;
};

/// `frame` is the area to tell the ground in.
LocalGround local_ground(const PointCloud& cloud, const GridFrame& frame, const GroundRules& rules,
                         Context& context);

}  // namespace stope::rasterizer
