#include "framework/compare/statistics/sign_flip.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "stope/random.hpp"

namespace stope {
namespace {

TEST(SignFlip, CountsAllWaysOfASmallSample) {
  // Of 8 ways to sign 1, 2 and 3, two are as far from 0 as 6; four as far as 4 = -1 + 2 + 3.
  EXPECT_DOUBLE_EQ(sign_flip_probability(std::vector<double>{1, 2, 3}, 0), 2.0 / 8);
  EXPECT_DOUBLE_EQ(sign_flip_probability(std::vector<double>{-1, 2, 3}, 0), 4.0 / 8);
  EXPECT_DOUBLE_EQ(sign_flip_probability(std::vector<double>(6, 0.1), 0), 2.0 / 64);
}

TEST(SignFlip, CountsWhatFisherCounted) {
  // Darwin's fifteen pairs of maize, eighths of an inch: 1726 of 32 768 ways lie as far from 0 as
  // 314 (Fisher, The Design of Experiments, 1935, sec. 21).
  const std::vector<double> maize{49, -67, 8, 16, 6, 23, 28, 41, 14, 29, 56, 24, 75, 60, -48};
  EXPECT_DOUBLE_EQ(sign_flip_probability(maize, 0), 1726.0 / 32768);
}

TEST(SignFlip, CannotBeLessSureThanItsWaysAreMany) {
  for (const std::size_t n : {1U, 6U, 10U, 15U, 40U}) {
    std::vector<double> sample(n);
    for (std::size_t i = 0; i < n; ++i) sample[i] = 1 + 0.1 * static_cast<double>(i);
    EXPECT_DOUBLE_EQ(sign_flip_probability(sample, 3), least_probability(n)) << n;
  }
  EXPECT_EQ(least_probability(0), 1);
}

TEST(SignFlip, IsCertainWhereThereIsNothingToSee) {
  EXPECT_EQ(sign_flip_probability(std::vector<double>{}, 0), 1);
  EXPECT_EQ(sign_flip_probability(std::vector<double>(9, 0.0), 0), 1);
  EXPECT_EQ(sign_flip_probability(std::vector<double>(40, 0.0), 0), 1);
}

TEST(SignFlip, IsNotMovedByZeros) {
  const std::vector<double> bare{1, 2, -0.5, 3}, with_zeros{1, 0, 2, -0.5, 0, 3};
  EXPECT_DOUBLE_EQ(sign_flip_probability(bare, 0), sign_flip_probability(with_zeros, 0));
}

TEST(SignFlip, OfALargeSampleIsNearTheExactOne) {
  std::vector<double> sample(18, 1.0);
  sample[0] = sample[1] = sample[2] = -1;
  // |sum| >= 12: at most 3 of one sign: 2 (1 + 18 + 153 + 816) of 2^18 ways.
  EXPECT_NEAR(sign_flip_probability(sample, 1), 1976.0 / 262144, 0.003);
}

TEST(SignFlip, IsUniformWhereThereIsNoDifference) {
  Random random(2);
  int below = 0;
  for (int trial = 0; trial < 1000; ++trial) {
    std::vector<double> sample(10);
    for (double& value : sample) value = random.normal();
    below += sign_flip_probability(sample, 0) <= 0.05 ? 1 : 0;
  }
  EXPECT_GE(below, 25);
  EXPECT_LE(below, 75);
}

}  // namespace
}  // namespace stope
