#pragma once

#include <vector>

#include "framework/compare/experiment/experiment.hpp"

namespace stope {

/// Reads `metrics:`: by name `{from: stage[.port], measure: figure, better: higher|lower, matters:
/// quantity}`. The figure is called as the metric if `measure` is left out. Reports what is wrong.
std::vector<ExperimentMetric> read_metrics(const LocatedNode& node, Diagnostics& diagnostics);

}  // namespace stope
