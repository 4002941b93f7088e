#include "framework/report/draw/simplify.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace stope::report {
namespace {

double distance_to_line(const Vector2& point, const std::vector<Vector2>& line) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Vector2 along = line[i] - line[i - 1];
    const double part =
        std::clamp((point - line[i - 1]).dot(along) / along.squaredNorm(), 0.0, 1.0);
    nearest = std::min(nearest, (point - line[i - 1] - part * along).norm());
  }
  return nearest;
}

TEST(Simplify, StaysWithinTheTolerance) {
  std::vector<Vector2> line;
  for (int i = 0; i <= 1000; ++i) line.emplace_back(i * 0.1, 5 * std::sin(i * 0.02));
  const auto fewer = simplified(line, 0.05);
  EXPECT_LT(fewer.size(), 100U);
  EXPECT_EQ(fewer.front(), line.front());
  EXPECT_EQ(fewer.back(), line.back());
  for (const Vector2& point : line) EXPECT_LE(distance_to_line(point, fewer), 0.05 + 1e-9);
}

TEST(Simplify, KeepsALoopAndDropsWhatIsNotFinite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto loop = simplified({{0, 0}, {10, 0}, {nan, 3}, {10, 10}, {0, 0}}, 0.1);
  EXPECT_EQ(loop.size(), 4U);
  EXPECT_TRUE(simplified({}, 1).empty());
}

}  // namespace
}  // namespace stope::report
