// Problem: how sure can one be of a statistic of a few recordings, without assuming how they are
// distributed.
// Idea: draw samples of the same size from the sample, with replacement, and look how the statistic
// spreads. The plain quantiles of that spread are shifted where the statistic is biased (z0: the
// share of resamples below the estimate) and where its spread changes with its value (a: from
// leaving out one value at a time). Of a handful of values all this is too narrow: the tails are
// then moved outward.
// Cost: resamples x size of the sample, plus a sort.
#include "framework/compare/statistics/bootstrap.hpp"

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>
#include <cmath>
#include <vector>

#include "stope/random.hpp"

namespace stope {
namespace {

double probability_of(double z) { return boost::math::cdf(boost::math::normal(), z); }
double z_of(double probability) {
  return boost::math::quantile(boost::math::normal(), probability);
}

std::vector<double> resampled(std::span<const double> sample, const Statistic& statistic,
                              const BootstrapRules& rules) {
  Random random(rules.seed);
  std::vector<double> drawn(sample.size()), values(static_cast<std::size_t>(rules.resamples));
  for (double& value : values) {
    for (double& one : drawn) one = sample[random.below(sample.size())];
    value = statistic(drawn);
  }
  std::sort(values.begin(), values.end());
  return values;
}

double bias_correction(const std::vector<double>& sorted, double estimate) {
  const auto range = std::equal_range(sorted.begin(), sorted.end(), estimate);
  const auto count = static_cast<double>(sorted.size());
  // Resamples equal to the estimate count half; a share of 0 or 1 would be infinitely far away.
  const double below = static_cast<double>(range.first - sorted.begin()) +
                       0.5 * static_cast<double>(range.second - range.first);
  return z_of(std::clamp(below / count, 0.5 / count, 1 - 0.5 / count));
}

double acceleration(std::span<const double> sample, const Statistic& statistic) {
  std::vector<double> left(sample.begin() + 1, sample.end()), values;
  for (std::size_t i = 0; i < sample.size(); ++i) {
    values.push_back(statistic(left));
    if (i < left.size()) left[i] = sample[i];
  }
  const double centre = mean_of(values);
  double squares = 0, cubes = 0;
  for (const double value : values) {
    squares += (centre - value) * (centre - value);
    cubes += (centre - value) * (centre - value) * (centre - value);
  }
  return squares > 0 ? cubes / (6 * squares * std::sqrt(squares)) : 0;
}

double quantile(const std::vector<double>& sorted, double probability) {
  const double place = probability * static_cast<double>(sorted.size()) - 0.5;
  const auto last = static_cast<double>(sorted.size() - 1);
  const double below = std::floor(std::clamp(place, 0.0, last));
  const double above = std::min(below + 1, last);
  const double part = std::clamp(place - below, 0.0, 1.0);
  return (1 - part) * sorted[static_cast<std::size_t>(below)] +
         part * sorted[static_cast<std::size_t>(above)];
}

class Resampling {
 public:
  Resampling(std::span<const double> sample, const Statistic& statistic,
             const BootstrapRules& rules)
      : values_(resampled(sample, statistic, rules)),
        z0_(bias_correction(values_, statistic(sample))),
        a_(acceleration(sample, statistic)) {}

  Interval percentile(double tail) const {
    return {quantile(values_, tail), quantile(values_, 1 - tail)};
  }
  Interval bca(double tail) const { return {corrected(z_of(tail)), corrected(-z_of(tail))}; }

 private:
  double corrected(double z) const {
    const double moved = z0_ + z;
    return quantile(values_, probability_of(z0_ + moved / (1 - a_ * moved)));
  }
  std::vector<double> values_;  ///< of the resamples, sorted
  double z0_, a_;
};

// Of a mean of few values the resamples spread too little, by n - 1 to n, and like a normal
// distribution where Student's is wanted.
double expanded_tail(double tail, std::size_t size) {
  const double n = static_cast<double>(size);
  const boost::math::students_t student(n - 1);
  return probability_of(boost::math::quantile(student, tail) * std::sqrt(n / (n - 1)));
}

bool all_equal(std::span<const double> sample) {
  return std::all_of(sample.begin(), sample.end(),
                     [&](double value) { return value == sample.front(); });
}

}  // namespace

double mean_of(std::span<const double> sample) {
  double sum = 0;
  for (const double value : sample) sum += value;
  return sum / static_cast<double>(sample.size());
}

Interval bca_interval(std::span<const double> sample, const Statistic& statistic,
                      const BootstrapRules& rules) {
  if (all_equal(sample)) return {statistic(sample), statistic(sample)};
  return Resampling(sample, statistic, rules).bca((1 - rules.confidence) / 2);
}

Interval small_sample_interval(std::span<const double> sample, const Statistic& statistic,
                               const BootstrapRules& rules) {
  if (all_equal(sample)) return {statistic(sample), statistic(sample)};
  const Resampling resampling(sample, statistic, rules);
  const double tail = expanded_tail((1 - rules.confidence) / 2, sample.size());
  const Interval corrected = resampling.bca(tail), plain = resampling.percentile(tail);
  return {std::min(corrected.low, plain.low), std::max(corrected.high, plain.high)};
}

}  // namespace stope
