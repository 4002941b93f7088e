#include "framework/compare/statistics/bootstrap.hpp"

#include <gtest/gtest.h>

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
