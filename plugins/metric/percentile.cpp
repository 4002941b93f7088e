#include "plugins/metric/percentile.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace stope::metric {

double percentile(std::vector<double>& values, double share) {
  if (values.empty()) return std::numeric_limits<double>::infinity();
  std::sort(values.begin(), values.end());
  const double place = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(std::floor(place));
  const std::size_t above = std::min(below + 1, values.size() - 1);
  if (values[below] == values[above]) return values[below];  // also if both are infinite
  return values[below] + (place - std::floor(place)) * (values[above] - values[below]);
}

double mean_of(const std::vector<double>& values) {
  if (values.empty()) return std::numeric_limits<double>::infinity();
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

}  // namespace stope::metric
