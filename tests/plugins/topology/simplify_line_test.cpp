#include "plugins/topology/simplify_line.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace stope::topology {
namespace {

/// A way that bends at random, wider here and narrower there.
std::vector<LinePoint> wander(std::mt19937& random, int count) {
  std::uniform_real_distribution<double> bend(-0.3, 0.3), change(-0.5, 0.5);
  std::vector<LinePoint> points{{0, 0, 5}};
  double heading = 0;
  for (int i = 1; i < count; ++i) {
    heading += bend(random);
    const LinePoint& last = points.back();
    points.push_back({last.x + std::cos(heading), last.y + std::sin(heading),
                      std::max(0.5, last.distance + change(random))});
  }
  return points;
}

double distance_to_line(const LinePoint& point, const std::vector<LinePoint>& line) {
  double least = 1e300;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const LinePoint &a = line[i - 1], &b = line[i];
    const double dx = b.x - a.x, dy = b.y - a.y, square = dx * dx + dy * dy;
    const double part =
        square > 0 ? std::clamp(((point.x - a.x) * dx + (point.y - a.y) * dy) / square, 0.0, 1.0)
                   : 0;
    least = std::min(least, distance_between(point, {a.x + part * dx, a.y + part * dy, 0}));
  }
  return least;
}

TEST(SimplifyLine, NoPointIsFartherOffThanTheToleranceOrAQuarterOfItsDistance) {
  std::mt19937 random(3);
  for (int round = 0; round < 40; ++round) {
    const std::vector<LinePoint> points = wander(random, 200);
    for (const double tolerance : {0.2, 2.0, 1e6}) {
      const std::vector<LinePoint> simple = simplify_line(points, tolerance);
      EXPECT_EQ(simple.front(), points.front());
      EXPECT_EQ(simple.back(), points.back());
      for (const LinePoint& point : points)
        EXPECT_LE(distance_to_line(point, simple), std::min(tolerance, point.distance / 4) + 1e-9);
    }
  }
}

TEST(SimplifyLine, AStraightLineIsTwoPoints) {
  std::vector<LinePoint> points;
  for (int i = 0; i < 50; ++i) points.push_back({i * 1.0, i * 2.0, 4});
  EXPECT_EQ(simplify_line(points, 0.1).size(), 2U);
}

TEST(SimplifyLine, HowWideARoadIsIsKeptAlongAStraightLine) {
  // A narrow place half way; drawn straight along the line, it would be lost.
  std::vector<LinePoint> points;
  for (int i = 0; i <= 40; ++i) points.push_back({i * 1.0, 0, i == 20 ? 2.0 : 8.0});
  const std::vector<LinePoint> simple = simplify_line(points, 0.1, 0.1);
  bool found = false;
  for (const LinePoint& point : simple) found |= point.distance == 2;
  EXPECT_TRUE(found);
}

}  // namespace
}  // namespace stope::topology
