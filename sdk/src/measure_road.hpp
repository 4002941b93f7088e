#pragma once

#include <span>

#include "stope/payloads/road_graph.hpp"

namespace stope {

/// Fills what canonicalize() measures of an edge: length, clearances, grade and curvature.
void measure_road(std::span<const RoadVertex> line, RoadEdge& edge);

}  // namespace stope
