#pragma once

#include <vector>

#include "plugins/metric/path_similarity.hpp"

namespace stope::metric {

/// The points of a graph that lie `interval`, 2 `interval`, … metres of travel from `start`, up to
/// `reach`, which counts; on every road that leads there, in the order of edges. The start itself
/// is none of them. Where two ways to a point are equally long it is there once.
std::vector<Vector2> travel_samples(const MeasuredGraph& graph, RoadPlace start, double interval,
                                    double reach);

}  // namespace stope::metric
