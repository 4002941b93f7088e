#include "plugins/export/simplify.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "stope/random.hpp"

namespace stope::exports {
namespace {

double distance(const RoadVertex& p, const RoadVertex& a, const RoadVertex& b) {
  double best = 1e300;
  for (int i = 0; i <= 2000; ++i) {
    const double t = i / 2000.0;
    best = std::min(best, std::hypot(a.x + t * (b.x - a.x) - p.x, a.y + t * (b.y - a.y) - p.y));
  }
  return best;
}

TEST(Simplify, EveryDroppedVertexLiesWithinTolerance) {
  Random random(3);
  for (int trial = 0; trial < 20; ++trial) {
    std::vector<RoadVertex> line{{0, 0, 0, 0}};
    for (int i = 0; i < 60; ++i)
      line.push_back(
          {line.back().x + random.uniform(0, 1), line.back().y + random.normal() * 0.3, 0, 0});
    const auto kept = simplify(line, 0.5);
    EXPECT_EQ(kept.front(), 0U);
    EXPECT_EQ(kept.back(), line.size() - 1);
    EXPECT_LT(kept.size(), line.size());
    for (std::size_t k = 1; k < kept.size(); ++k) {
      for (std::size_t i = kept[k - 1]; i <= kept[k]; ++i)
        EXPECT_LE(distance(line[i], line[kept[k - 1]], line[kept[k]]), 0.502);
    }
  }
}

TEST(Simplify, ALoopKeepsItsShape) {
  const std::vector<RoadVertex> loop{{0, 0, 0, 0}, {5, 0, 0, 0}, {5, 5, 0, 0}, {0, 0, 0, 0}};
  EXPECT_EQ(simplify(loop, 0.1).size(), 4U);
}

}  // namespace
}  // namespace stope::exports
