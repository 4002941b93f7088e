#include "plugins/topology/regions/changed_squares.hpp"

#include <gtest/gtest.h>

#include <set>
#include <utility>

#include "stope/random.hpp"

namespace stope::topology {
namespace {

using Squares = std::set<std::pair<std::int32_t, std::int32_t>>;  // column, row of squares

constexpr std::int32_t kWidth = 101, kHeight = 75;

/// The squares that a box has cells in, of a grid with its margin.
Squares squares_of(std::int32_t left, std::int32_t bottom, std::int32_t right, std::int32_t top) {
  Squares squares;
  for (std::int32_t y = bottom; y <= top; ++y)
    for (std::int32_t x = left; x <= right; ++x)
      if (x >= -1 && y >= -1 && x <= kWidth && y <= kHeight)
        squares.insert({(x + 1) / ChangedSquares::kSide, (y + 1) / ChangedSquares::kSide});
  return squares;
}

Squares listed(const ChangedSquares& changed) {
  Squares squares;
  changed.for_each([&](std::int32_t left, std::int32_t bottom) {
    EXPECT_TRUE(
        squares.insert({(left + 1) / ChangedSquares::kSide, (bottom + 1) / ChangedSquares::kSide})
            .second);
  });
  return squares;
}

TEST(ChangedSquares, AreThoseThatHaveCellsAndNoOthers) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Random random(seed);
    const auto draw = [&](std::uint64_t count) {
      return static_cast<std::int32_t>(random.below(count));
    };
    ChangedSquares changed(kWidth, kHeight);
    Squares expected;
    EXPECT_FALSE(changed.any());
    for (int i = 0; i < 4; ++i) {
      const std::int32_t x = draw(kWidth), y = draw(kHeight), reach = draw(13);
      changed.add(x, y, reach);
      expected.merge(squares_of(x - reach, y - reach, x + reach, y + reach));
    }
    EXPECT_EQ(listed(changed), expected);
    const std::int32_t wider = draw(20);
    Squares wide;
    for (const auto& [x, y] : expected) {
      const std::int32_t left = x * ChangedSquares::kSide - 1,
                         bottom = y * ChangedSquares::kSide - 1;
      wide.merge(squares_of(left - wider, bottom - wider, left + 7 + wider, bottom + 7 + wider));
    }
    EXPECT_EQ(listed(changed.widened(wider)), wide);
    for (int i = 0; i < 100; ++i) {
      const std::int32_t x = draw(kWidth), y = draw(kHeight), reach = draw(40);
      bool touches = false;
      for (const auto& square : squares_of(x - reach, y - reach, x + reach, y + reach))
        touches = touches || expected.count(square) > 0;
      EXPECT_EQ(changed.touch(x, y, reach), touches);
    }
  }
}

}  // namespace
}  // namespace stope::topology
