#pragma once

#include <span>
#include <vector>

#include "stope/geometry.hpp"

namespace stope::source {

/// A uniform cubic B-spline of `controls`, sampled about every `step` metres. Its curvature is
/// continuous, as a surveyed road's is. An open one starts at the first control and ends at the
/// last, along the first and last leg; a closed one does not repeat its first point.
std::vector<Vector2> smooth_curve(std::span<const Vector2> controls, bool closed, double step);

/// The smallest radius of curvature along a polyline, by circles through points `reach` apart.
double smallest_radius(std::span<const Vector2> points, bool closed, std::size_t reach = 3);

/// Distances from the first point to each point along the polyline.
std::vector<double> stations(std::span<const Vector2> points);

/// Averages `values` over `half` samples to both sides (fewer at the ends).
std::vector<double> moving_average(std::span<const double> values, std::size_t half);

}  // namespace stope::source
