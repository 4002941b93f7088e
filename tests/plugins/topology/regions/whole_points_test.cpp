#include "plugins/topology/regions/whole_points.hpp"

#include <gtest/gtest.h>

#include "plugins/topology/regions/visit_convex.hpp"
#include "stope/random.hpp"

namespace stope::topology {
namespace {

TEST(WholePoints, OfAPointALineASquareAndATriangle) {
  const std::vector<HullPoint> point{{3, 4}}, line{{0, 0}, {4, 2}},
      square{{0, 0}, {2, 0}, {2, 2}, {0, 2}}, triangle{{0, 0}, {4, 0}, {0, 4}};
  EXPECT_EQ(whole_points_in(point), 1);
  EXPECT_EQ(whole_points_in(line), 3);
  EXPECT_EQ(whole_points_in(square), 9);
  EXPECT_EQ(whole_points_in(triangle), 15);
}

TEST(WholePoints, AreThoseOfTheRowsOneByOne) {
  Random random(11);
  for (int run = 0; run < 2000; ++run) {
    std::vector<HullPoint> points;
    const std::uint64_t count = 1 + random.below(12);
    for (std::uint64_t i = 0; i < count; ++i)
      points.push_back({static_cast<std::int32_t>(random.below(40)) - 20,
                        static_cast<std::int32_t>(random.below(40)) - 20});
    const std::vector<HullPoint> hull = convex_hull(points);
    std::int64_t expected = 0;
    visit_convex(hull, [&](std::int32_t, std::int32_t first, std::int32_t last) {
      expected += last - first + 1;
    });
    EXPECT_EQ(whole_points_in(hull), expected) << "run " << run;
  }
}

}  // namespace
}  // namespace stope::topology
