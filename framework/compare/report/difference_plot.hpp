#pragma once

#include <string>
#include <vector>

#include "framework/compare/verdicts.hpp"

namespace stope::report {

/// For each metric the paired differences of all arms on one axis: a dot a recording, the interval
/// of their mean, and the band of +- delta.
std::string difference_plots_html(const Comparison& comparison,
                                  const std::vector<ArmVerdicts>& verdicts);

/// Round numbers inside [low, high], at most six steps of them.
std::vector<double> ticks(double low, double high);

}  // namespace stope::report
