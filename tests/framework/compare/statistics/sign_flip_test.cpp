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
  std::vector<double> sample(14, 1.0);
  sample[0] = -1;
  // |sum| >= 12: 0 or 1 or 13 or 14 minus signs: (1 + 14) * 2 of 2^14.
  EXPECT_NEAR(sign_flip_probability(sample, 1), 30.0 / 16384, 0.0015);
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
