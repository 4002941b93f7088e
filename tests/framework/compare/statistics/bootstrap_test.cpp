#include "framework/compare/statistics/bootstrap.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <vector>

#include "stope/random.hpp"

namespace stope {
namespace {

double variance_of(std::span<const double> sample) {
  const double mean = mean_of(sample);
  double squares = 0;
  for (const double value : sample) squares += (value - mean) * (value - mean);
  return squares / static_cast<double>(sample.size());
}

TEST(Bootstrap, GivesTheIntervalOfThePublishedExample) {
  // Efron and Tibshirani 1993, tables 14.1 and 14.2: spatial test A, variance, 90 %: (115.8, 259.6)
  // from 2000 resamples; two standard errors of such bounds are about 4.
  const std::vector<double> scores{48, 36, 20, 29, 42, 42, 20, 42, 22, 41, 45, 14, 6,
                                   0,  33, 28, 34, 4,  32, 24, 47, 41, 24, 26, 30, 41};
  EXPECT_NEAR(variance_of(scores), 171.5, 0.05);
  const Interval interval = bca_interval(scores, variance_of, {0.90, 10'000, 7});
  EXPECT_NEAR(interval.low, 115.8, 4);
  EXPECT_NEAR(interval.high, 259.6, 6);
}

// What R's boot.ci gives from a million resamples (a test of SciPy's bootstrap). Two standard
// errors of a bound from 10 000 are about 0.8.
const std::vector<double> kOfR{10, 12, 12.5, 12.5, 13.9, 15,  21,  22,
                               23, 34, 50,   81,   89,   121, 134, 213};

TEST(Bootstrap, GivesTheIntervalThatRGives) {
  const Interval interval = bca_interval(kOfR, mean_of, {0.95, 10'000, 1});
  EXPECT_NEAR(interval.low, 32.31, 1);
  EXPECT_NEAR(interval.high, 91.43, 1.5);
}

// All resamples of a few values, not a random ten thousand of them.
std::vector<double> all_resampled_means(const std::vector<double>& sample) {
  const std::size_t n = sample.size();
  const auto ways = static_cast<std::size_t>(std::llround(std::pow(n, n)));
  std::vector<double> means;
  for (std::size_t way = 0; way < ways; ++way) {
    double sum = 0;
    for (std::size_t rest = way, i = 0; i < n; ++i, rest /= n) sum += sample[rest % n];
    means.push_back(sum / static_cast<double>(n));
  }
  std::sort(means.begin(), means.end());
  return means;
}

TEST(Bootstrap, IsNearWhatAllResamplesGive) {
  const boost::math::normal normal;
  for (const std::vector<double>& sample : {std::vector<double>{1, 2.5, 4.1, 5.2, 7.7},
                                            {0.1, 0.3, 0.4, 0.9, 4},
                                            {-3, -1, 0.2, 6, 7, 8}}) {
    const std::vector<double> means = all_resampled_means(sample);
    const double estimate = mean_of(sample);
    double below = 0, squares = 0, cubes = 0;
    for (const double mean : means)
      below += mean < estimate - 1e-12 ? 1 : (mean < estimate + 1e-12 ? 0.5 : 0);
    // Of a mean the acceleration is a sixth of its skewness (Efron 1987, eq. 7.3 with n^-1/2).
    for (const double value : sample) {
      squares += std::pow(value - estimate, 2);
      cubes += std::pow(value - estimate, 3);
    }
    const double a = cubes / (6 * std::pow(squares, 1.5));
    const double z0 = quantile(normal, below / static_cast<double>(means.size()));
    const auto share_below = [&](double bound) {
      const auto at = std::lower_bound(means.begin(), means.end(), bound - 1e-12);
      return static_cast<double>(at - means.begin()) / static_cast<double>(means.size());
    };
    const auto share_up_to = [&](double bound) {
      const auto at = std::upper_bound(means.begin(), means.end(), bound + 1e-12);
      return static_cast<double>(at - means.begin()) / static_cast<double>(means.size());
    };
    const auto wanted = [&](double tail) {
      const double z = z0 + quantile(normal, tail);
      return cdf(normal, z0 + z / (1 - a * z));
    };
    const Interval interval = bca_interval(sample, mean_of, {0.95, 40'000, 11});
    for (const auto& [bound, tail] : {std::pair(interval.low, 0.025), {interval.high, 0.975}}) {
      // The bound splits the true distribution at the wanted share; 3 standard errors of 40 000.
      EXPECT_LE(share_below(bound), wanted(tail) + 0.004);
      EXPECT_GE(share_up_to(bound), wanted(tail) - 0.004);
    }
  }
}

TEST(SmallSampleInterval, HasStudentsWidthWhereThereIsNoSkew) {
  const std::vector<double> sample{-5, -3, -2, -1, 1, 2, 3, 5};
  const Interval interval = small_sample_interval(sample, mean_of, {0.95, 10'000, 1});
  const double half = 2.3646 * std::sqrt(78.0 / 7 / 8);  // Student's 97.5 % at 7 degrees
  EXPECT_NEAR(interval.high, half, 0.06 * half);
  EXPECT_NEAR(interval.low, -half, 0.06 * half);
}

TEST(SmallSampleInterval, IsNeverTighterThanThePlainOne) {
  Random random(8);
  for (int trial = 0; trial < 50; ++trial) {
    std::vector<double> sample(6 + random.below(10));
    for (double& value : sample) value = std::exp(random.normal());
    const BootstrapRules rules{0.95, 2000, random.bits()};
    const Interval plain = bca_interval(sample, mean_of, rules);
    EXPECT_TRUE(plain.inside(small_sample_interval(sample, mean_of, rules).low,
                             small_sample_interval(sample, mean_of, rules).high));
  }
}

TEST(SmallSampleInterval, HoldsTheMeanOfSixAsOftenAsItSaysWhereThePlainOneDoesNot) {
  Random random(5);
  int held = 0, plain_held = 0;
  for (int trial = 0; trial < 400; ++trial) {
    std::vector<double> sample(6);
    for (double& value : sample) value = 3 + random.normal();
    const BootstrapRules rules{0.95, 1000, random.bits()};
    held += small_sample_interval(sample, mean_of, rules).excludes(3) ? 0 : 1;
    plain_held += bca_interval(sample, mean_of, rules).excludes(3) ? 0 : 1;
  }
  EXPECT_GE(held, 364);  // 380 expected, of 95 %; 3.5 standard deviations
  EXPECT_LE(plain_held, 364);
}

TEST(Bootstrap, OfEqualValuesHasNoWidth) {
  const Interval interval = bca_interval(std::vector<double>(8, 2.5), mean_of);
  EXPECT_EQ(interval.low, 2.5);
  EXPECT_EQ(interval.high, 2.5);
}

TEST(Bootstrap, IsTheSameForTheSameSeed) {
  const std::vector<double> sample{1, 4, 2, 8, 5, 7};
  const Interval first = bca_interval(sample, mean_of, {0.95, 1000, 3});
  const Interval again = bca_interval(sample, mean_of, {0.95, 1000, 3});
  EXPECT_EQ(first.low, again.low);
  EXPECT_EQ(first.high, again.high);
  EXPECT_EQ(small_sample_interval(std::vector<double>{4, 4}, mean_of).high, 4);
}

TEST(Bootstrap, HoldsTheTrueMeanAboutAsOftenAsItSays) {
  Random random(5);
  int held = 0;
  for (int trial = 0; trial < 300; ++trial) {
    std::vector<double> sample(20);
    for (double& value : sample) value = 3 + random.normal();
    held += bca_interval(sample, mean_of, {0.95, 1000, random.bits()}).excludes(3) ? 0 : 1;
  }
  // Binomial: 285 expected; bootstrap intervals of small samples are known to be a little narrow.
  EXPECT_GE(held, 270);
  EXPECT_LE(held, 297);
}

}  // namespace
}  // namespace stope
