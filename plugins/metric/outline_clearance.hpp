#pragma once

#include <array>

#include "plugins/metric/drive_validity.hpp"

namespace stope::metric {

/// The corners of a convex outline in the map's frame, in one sense of rotation; metres.
using Outline = std::array<Vector2, 4>;

/// The truck's rectangle when the middle of its rear axle is at `pose`.
Outline outline_of(const TruckLimits& truck, const Pose2& pose);

/// Metres from an outline to the nearest obstacle square, at most `farthest`; 0 if they touch.
/// Unknown cells, cells that are as likely taken as free, and all beyond the map are obstacles.
double clearance_of(const Outline& outline, const OccupancyGrid& grid, double farthest);

}  // namespace stope::metric
