#include "plugins/source/synthetic_pit/height_pyramid.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

#include "stope/random.hpp"

namespace stope::source {
namespace {

Terrain terrain_of(std::int32_t width, std::int32_t height, double resolution,
                   const std::function<double(double, double)>& level) {
  Terrain terrain;
  terrain.frame = {width, height, resolution, {-3.0, 2.0, 0.0}};
  for (std::int32_t row = 0; row < height; ++row) {
    for (std::int32_t column = 0; column < width; ++column) {
      const Vector2 place = terrain.frame.centre({column, row});
      terrain.height.push_back(static_cast<float>(level(place.x(), place.y())));
    }
  }
  return terrain;
}

TEST(HeightPyramid, MeetsALevelPlaneWhereGeometrySays) {
  const Terrain terrain = terrain_of(200, 150, 0.5, [](double, double) { return 1.0; });
  const HeightPyramid pyramid(terrain);
  const Vector3 origin(40, 40, 4.0);
  for (int degrees = 0; degrees < 360; degrees += 7) {
    const double azimuth = degrees * std::numbers::pi / 180, down = 0.15;
    const Vector3 beam(std::cos(down) * std::cos(azimuth), std::cos(down) * std::sin(azimuth),
                       -std::sin(down));
    const auto hit = pyramid.cast(origin, beam, 100);
    ASSERT_TRUE(hit) << degrees;
    EXPECT_NEAR(hit->range, 3.0 / std::sin(down), 1e-6);
  }
}

TEST(HeightPyramid, MeetsAWallWhereGeometrySays) {
  // A wall of 10 m with one cell's run at x = 50.
  const Terrain terrain =
      terrain_of(256, 64, 0.5, [](double x, double) { return x > 50 ? 10.0 : 0.0; });
  const HeightPyramid pyramid(terrain);
  const auto hit = pyramid.cast({10, 15, 5}, {1, 0, 0}, 100);
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->range, 40.0, 0.26);
  EXPECT_FALSE(pyramid.cast({10, 15, 5}, {1, 0, 0}, 39));
  EXPECT_FALSE(pyramid.cast({10, 15, 5}, {-1, 0, 0}, 100));
  EXPECT_FALSE(pyramid.cast({10, 15, 11}, {1, 0, 0}, 100));
}

TEST(HeightPyramid, AgreesWithWalkingAlongTheRay) {
  Random random(5);
  const double phase = random.uniform(0, 6);
  const Terrain terrain = terrain_of(97, 130, 0.7, [&](double x, double y) {
    return 3 * std::sin(0.31 * x + phase) + 2 * std::cos(0.23 * y) + random.uniform(-0.5, 0.5);
  });
  const HeightPyramid pyramid(terrain);
  int hits = 0;
  for (int i = 0; i < 600; ++i) {
    const Vector3 origin(random.uniform(0, 60), random.uniform(5, 85), random.uniform(6, 12));
    Vector3 beam(random.normal(), random.normal(), 0.4 * random.normal());
    beam.normalize();
    constexpr double kRange = 60, kStep = 0.01;
    double walked = -1;
    for (double t = 0; t < kRange; t += kStep) {
      const Vector3 at = origin + t * beam;
      const Vector2 cell = terrain.frame.to_grid(at.x(), at.y());
      if (cell.x() < 0.5 || cell.y() < 0.5 || cell.x() > terrain.frame.width - 0.5 ||
          cell.y() > terrain.frame.height - 0.5)
        break;
      if (at.z() <= terrain.height_at(at.x(), at.y())) {
        walked = t;
        break;
      }
    }
    const auto hit = pyramid.cast(origin, beam, kRange);
    if (walked < 0) {
      // A graze thinner than a step, or a hit just beyond the last one, is all that may differ.
      if (hit && hit->range < kRange - kStep) {
        const Vector3 at = origin + hit->range * beam;
        EXPECT_NEAR(at.z(), terrain.height_at(at.x(), at.y()), 1e-3);
      }
      continue;
    }
    ASSERT_TRUE(hit) << i;
    EXPECT_LE(hit->range, walked + 1e-9);
    EXPECT_GT(hit->range, walked - 2 * kStep - 0.05);
    ++hits;
  }
  EXPECT_GT(hits, 100);
}

}  // namespace
}  // namespace stope::source
