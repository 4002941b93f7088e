#pragma once

#include <optional>
#include <string>

#include "framework/compare/comparison.hpp"
#include "framework/compare/experiment/experiment.hpp"
#include "stope/payloads/measures.hpp"

namespace stope {

/// What was found of a metric in what its stage measured.
struct MeasureReading {
  double value = 0;     ///< NaN if it cannot be used
  std::string why_not;  ///< a sentence, if it cannot
};

/// Finds a metric's figure in the Measures of its stage (none: it gave nothing). The first that is
/// found gives `compared` its unit, and turns the smallest difference that matters into it.
MeasureReading read_measure(const ExperimentMetric& metric, const std::optional<Measures>& measures,
                            ComparedMetric& compared);

}  // namespace stope
