#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "stope/payloads/road_graph.hpp"

namespace stope::exports {

/// The vertices of a polyline to keep so that the rest lie within `tolerance` metres of it (Douglas
/// and Peucker 1973): places in `line`, rising, both ends among them. 0 keeps all.
std::vector<std::size_t> simplify(std::span<const RoadVertex> line, double tolerance);

}  // namespace stope::exports
