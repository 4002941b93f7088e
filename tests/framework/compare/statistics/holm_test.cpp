#include "framework/compare/statistics/holm.hpp"

#include <gtest/gtest.h>

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

TEST(Holm, NeverExceedsOneAndLeavesASingleOneAlone) {
  EXPECT_EQ(holm(std::vector<double>{0.6, 0.9}), (std::vector<double>{1, 1}));
  EXPECT_EQ(holm(std::vector<double>{0.2}), std::vector<double>{0.2});
  EXPECT_TRUE(holm({}).empty());
}

}  // namespace
}  // namespace stope
