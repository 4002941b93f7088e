#pragma once

#include <vector>

#include "stope/payloads/path.hpp"
#include "stope/payloads/road_graph.hpp"

namespace stope::planner {

/// Metres between points of a path, at least: less would fill the memory and say no more.
constexpr double kLeastStep = 0.01;

/// Points along a polyline, evenly spaced no farther apart than `step` metres, both ends included.
/// Each lies on the line; z and clearance are linear between its vertices. Heading is taken over
/// `smoothing` metres before and behind the point, curvature is the change of that heading.
std::vector<PathPoint> sample_path(const std::vector<RoadVertex>& line, double step,
                                   double smoothing);

/// Metres along a polyline in the plane.
double length_of(const std::vector<RoadVertex>& line);

}  // namespace stope::planner
