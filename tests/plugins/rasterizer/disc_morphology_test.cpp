#include "plugins/rasterizer/disc_morphology.hpp"

#include <gtest/gtest.h>

#include "stope/random.hpp"

namespace stope::rasterizer {
namespace {

Mask random_mask(Random& random, std::uint64_t one_in) {
  Mask mask{static_cast<std::int32_t>(1 + random.below(40)),
            static_cast<std::int32_t>(1 + random.below(40)),
            {}};
  for (std::int32_t i = 0; i < mask.width * mask.height; ++i)
    mask.cells.push_back(random.below(one_in) == 0 ? 1 : 0);
  return mask;
}

bool at(const Mask& mask, std::int32_t x, std::int32_t y, bool beyond) {
  if (x < 0 || y < 0 || x >= mask.width || y >= mask.height) return beyond;
  return mask.cells[static_cast<std::size_t>(y * mask.width + x)] != 0;
}

// Whether any cell within the disc is `value`.
bool any_within(const Mask& mask, std::int32_t x, std::int32_t y, double radius, bool value) {
  const auto reach = static_cast<std::int32_t>(radius) + 1;
  for (std::int32_t dy = -reach; dy <= reach; ++dy) {
    for (std::int32_t dx = -reach; dx <= reach; ++dx) {
      if (dx * dx + dy * dy > radius * radius) continue;
      if (at(mask, x + dx, y + dy, !value) == value) return true;
    }
  }
  return false;
}

TEST(DiscMorphology, DilationAndClosingEqualBruteForce) {
  Random random(4);
  for (int trial = 0; trial < 80; ++trial) {
    const Mask mask = random_mask(random, 2 + random.below(60));
    const double radius =
        trial % 4 == 0 ? static_cast<double>(random.below(6)) : random.uniform(0, 7);
    const Mask dilated = dilate(mask, radius), closed = close(mask, radius);
    Mask truth{mask.width, mask.height, {}};
    for (std::int32_t y = 0; y < mask.height; ++y)
      for (std::int32_t x = 0; x < mask.width; ++x)
        truth.cells.push_back(any_within(mask, x, y, radius, true) ? 1 : 0);
    ASSERT_EQ(dilated.cells, truth.cells) << "radius " << radius;
    for (std::int32_t y = 0; y < mask.height; ++y) {
      for (std::int32_t x = 0; x < mask.width; ++x) {
        const bool open = any_within(truth, x, y, radius, false);
        ASSERT_EQ(at(closed, x, y, false), !open) << "radius " << radius;
        if (at(mask, x, y, false)) {
          ASSERT_TRUE(at(closed, x, y, false));
        }
      }
    }
  }
}

}  // namespace
}  // namespace stope::rasterizer
