#pragma once

#include <cstdint>
#include <functional>
#include <span>

namespace stope {

/// Where the true value of a statistic lies, with a stated confidence.
struct Interval {
  double low = 0, high = 0;
  bool excludes(double value) const { return value < low || value > high; }
  bool inside(double least, double most) const { return least <= low && high <= most; }
};

/// A number made of a sample.
using Statistic = std::function<double(std::span<const double>)>;

/// The arithmetic mean, summed in order.
double mean_of(std::span<const double> sample);

/// How an interval is found.
struct BootstrapRules {
  double confidence = 0.95;
  int resamples = 10'000;
  std::uint64_t seed = 0;
};

/// The bias-corrected and accelerated bootstrap interval of a statistic (Efron and Tibshirani, An
/// Introduction to the Bootstrap, 1993, sec. 14.3). The sample must not be empty and must be
/// finite. A sample of equal values has an interval without width.
Interval bca_interval(std::span<const double> sample, const Statistic& statistic,
                      const BootstrapRules& rules = {});

}  // namespace stope
