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

/// The same interval made honest for a handful of values, of which the plain one holds the mean in
/// 79 to 92 % of all cases where it says 95 % (docs/verdicts.md). Its tails are those that
/// Student's distribution has at this size (the expanded percentiles of Hesterberg, What Teachers
/// Should Know About the Bootstrap, 2015), and the two corrections, which six values cannot tell
/// well, may widen it beyond the interval without them but never narrow it.
Interval small_sample_interval(std::span<const double> sample, const Statistic& statistic,
                               const BootstrapRules& rules = {});

}  // namespace stope
