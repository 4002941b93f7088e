#pragma once

#include "framework/compare/experiment/experiment.hpp"
#include "framework/pipeline/plan.hpp"

namespace stope {

/// The output of a plan that gives a metric's Measures. Reports it, where the experiment names the
/// stage, if there is none: no such stage or port, of another type, a stream, or more than one.
PlannedSource metric_source(const ExperimentMetric& metric, const Plan& plan,
                            Diagnostics& diagnostics);

}  // namespace stope
