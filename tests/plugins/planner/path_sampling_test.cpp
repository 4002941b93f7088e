#include "plugins/planner/path_sampling.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace stope::planner {
namespace {

TEST(PathSampling, ACircleHasItsRadiusEverywhere) {
  std::vector<RoadVertex> line;
  for (int i = 0; i <= 900; ++i) {
    const double angle = i * 0.002;
    line.push_back({20 * std::cos(angle), 20 * std::sin(angle), 3, 4});
  }
  const auto points = sample_path(line, 1.0, 2.0);
  EXPECT_NEAR(length_of(line), 36, 1e-3);
  ASSERT_EQ(points.size(), 37U);
  for (std::size_t i = 2; i + 2 < points.size(); ++i) {
    const double angle = std::atan2(points[i].y, points[i].x);
    const double tangent = angle + std::numbers::pi / 2;
    EXPECT_NEAR(std::remainder(points[i].yaw - tangent, 2 * std::numbers::pi), 0, 0.01);
    EXPECT_NEAR(points[i].curvature, 1 / 20.0, 0.002);
    EXPECT_NEAR(std::hypot(points[i].x, points[i].y), 20, 1e-3);
    EXPECT_EQ(points[i].z, 3);
    EXPECT_EQ(points[i].clearance, 4);
  }
}

TEST(PathSampling, KeepsBothEndsAndTheSpacing) {
  const std::vector<RoadVertex> line{{0, 0, 0, 1}, {0, 0, 0, 1}, {3, 0, 3, 4}, {3, 4.5, 3, 4}};
  const auto points = sample_path(line, 1.0, 1.0);
  EXPECT_EQ(points.front().x, 0);
  EXPECT_EQ(points.back().y, 4.5);
  EXPECT_EQ(points.size(), 9U);
  for (std::size_t i = 1; i < points.size(); ++i)
    EXPECT_LE(std::hypot(points[i].x - points[i - 1].x, points[i].y - points[i - 1].y), 1 + 1e-9);
  EXPECT_NEAR(points[1].z, points[1].x, 1e-12);
}

TEST(PathSampling, OnePlaceIsAPathOfThatPlace) {
  const auto points = sample_path({{2, 3, 0, 1}}, 1.0, 1.0);
  ASSERT_FALSE(points.empty());
  for (const auto& point : points) EXPECT_EQ(point.x, 2);
  EXPECT_TRUE(sample_path({}, 1.0, 1.0).empty());
}

}  // namespace
}  // namespace stope::planner
