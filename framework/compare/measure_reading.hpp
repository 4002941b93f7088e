#pragma once

#include <optional>
#include <string>

#include "framework/compare/comparison.hpp"
#include "framework/compare/experiment/experiment.hpp"
#include "stope/payloads/measures.hpp"

namespace stope {

/// A metric's figure as it stands in Measures, or why there is none that the metric can mean.
struct Figure {
  double value = 0;                  ///< as measured; may be no finite number
  std::string unit;                  ///< SI; empty: a plain number
  double smallest_that_matters = 0;  ///< in `unit`
  const char* wrong = nullptr;       ///< the code of what is wrong with the metric, or none
  std::string sentence, hint;        ///< of what is wrong
};

/// Finds the figure. `stage` is who measured, for messages.
Figure find_figure(const ExperimentMetric& metric, const Measures& measures,
                   const std::string& stage);

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
