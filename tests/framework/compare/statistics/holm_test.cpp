#include "framework/compare/statistics/holm.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>

#include "stope/random.hpp"

namespace stope {
namespace {

TEST(Holm, AdjustsAsWorkedOutByHand) {
  // In order: 4 x 0.005, 3 x 0.01, 2 x 0.03, then no less than the one before.
  const std::vector<double> adjusted = holm(std::vector<double>{0.01, 0.04, 0.03, 0.005});
  ASSERT_EQ(adjusted.size(), 4U);
  EXPECT_DOUBLE_EQ(adjusted[0], 0.03);
  EXPECT_DOUBLE_EQ(adjusted[1], 0.06);
  EXPECT_DOUBLE_EQ(adjusted[2], 0.06);
  EXPECT_DOUBLE_EQ(adjusted[3], 0.02);
}

TEST(Holm, GivesWhatRGives) {
  // p.adjust(c(0.01, 0.02, 0.03, 0.04, 0.05), "holm")
  const std::vector<double> adjusted = holm(std::vector<double>{0.01, 0.02, 0.03, 0.04, 0.05});
  const std::vector<double> published{0.05, 0.08, 0.09, 0.09, 0.09};
  for (std::size_t i = 0; i < published.size(); ++i) EXPECT_NEAR(adjusted[i], published[i], 1e-12);
}

TEST(Holm, IsTheClosedTestOfAllSetsByBonferroni) {
  // Marcus, Peritz and Gabriel 1976: one is believed if every set it is in is, at size x least.
  Random random(4);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<double> chances(1 + random.below(7));
    for (double& chance : chances) chance = 0.2 * random.uniform();
    std::vector<double> closed(chances.size(), 0.0);
    for (unsigned set = 1; set < 1U << chances.size(); ++set) {
      double least = 1;
      for (std::size_t i = 0; i < chances.size(); ++i)
        if (set >> i & 1) least = std::min(least, chances[i]);
      for (std::size_t i = 0; i < chances.size(); ++i)
        if (set >> i & 1)
          closed[i] = std::max(closed[i], std::min(1.0, std::popcount(set) * least));
    }
    const std::vector<double> adjusted = holm(chances);
    for (std::size_t i = 0; i < chances.size(); ++i) EXPECT_DOUBLE_EQ(adjusted[i], closed[i]);
  }
}

TEST(Holm, NeverExceedsOneAndLeavesASingleOneAlone) {
  EXPECT_EQ(holm(std::vector<double>{0.6, 0.9}), (std::vector<double>{1, 1}));
  EXPECT_EQ(holm(std::vector<double>{0.2}), std::vector<double>{0.2});
  EXPECT_TRUE(holm({}).empty());
}

}  // namespace
}  // namespace stope
