#include "plugins/topology/outline_shape.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "tests/plugins/topology/outline_grids.hpp"

namespace stope::topology {
namespace {

TEST(OutlineShape, WaysAreAsLongAsTheWallsWhateverTheirDirection) {
  for (const double degrees : {0.0, 3.0, 11.0, 26.565, 30.0, 45.0, 71.0, 90.0}) {
    const OutlineWays ways = measure_ways(outlines_of(turned_strip(degrees)));
    ASSERT_EQ(ways.whole.size(), 1U);
    EXPECT_NEAR(static_cast<double>(ways.whole[0]) / OutlineWays::kUnit * 0.5, 200, 8) << degrees;
  }
  const OutlineWays circle = measure_ways(outlines_of(grid_where(
      100, 100, 0.5, [](double x, double y) { return std::hypot(x - 50, y - 50) < 40; })));
  EXPECT_NEAR(static_cast<double>(circle.whole.at(0)) / OutlineWays::kUnit * 0.5,
              2 * std::numbers::pi * 40, 5);
}

TEST(OutlineShape, TheWayBetweenTwoEdgesIsTheShorterOne) {
  const Outlines outlines = outlines_of(turned_strip(20));
  const OutlineWays ways = measure_ways(outlines);
  const Outline& outline = outlines.list.at(0);
  const double whole = static_cast<double>(ways.whole[0]) / OutlineWays::kUnit;
  for (std::int32_t i = 0; i < outline.count; i += 7) {
    for (std::int32_t k = 0; k < outline.count; k += 11) {
      const double way = ways.between(outline.first + i, outline.first + k, 0);
      EXPECT_LE(way, whole / 2 + 1e-9);
      EXPECT_EQ(way, ways.between(outline.first + k, outline.first + i, 0));
    }
  }
}

}  // namespace
}  // namespace stope::topology
