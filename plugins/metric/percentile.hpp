#pragma once

#include <vector>

namespace stope::metric {

/// The value below which `share` (0 to 1) of the values lie, interpolated between neighbours;
/// infinite if there are none. Sorts `values`.
double percentile(std::vector<double>& values, double share);

/// Their mean, summed in order; infinite if there are none.
double mean_of(const std::vector<double>& values);

}  // namespace stope::metric
