#include <gtest/gtest.h>

#include <cmath>

#include "plugins/source/synthetic_pit/noise.hpp"
#include "stope/payloads/point_label.hpp"
#include "tests/plugins/source/pit_worlds.hpp"

namespace stope::source {
namespace {

const World& pit() {
  static const World world(small_pit(), 7);
  return world;
}

Vector3 beam_of(const LidarScan& scan, std::size_t i) {
  return {scan.points[i].x, scan.points[i].y, scan.points[i].z};
}

bool on_object(const LidarScan& scan, std::size_t i) {
  return scan.label[i] == static_cast<std::uint8_t>(PointLabel::kObject);
}

TEST(SyntheticSensor, EveryPointOfTheGroundLiesOnItOnceTheMotionIsUndone) {
  PitParameters exact = small_pit();
  exact.range_noise = 0;
  const World world(exact, 7);
  for (std::size_t k = 0; k < world.sweeps.count; k += 40) {
    const LidarScan scan = world.scan(k);
    ASSERT_GT(scan.points.size(), 1000u);
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
      if (on_object(scan, i)) continue;
      const Pose pose = pose_at(world.trajectory, world.sweeps.end(k) + scan.time_offset[i]);
      const Vector3 point = pose * beam_of(scan, i);
      // Single precision at 100 m, on a wall.
      EXPECT_NEAR(point.z(), world.terrain.height_at(point.x(), point.y()), 2e-3);
    }
  }
}

TEST(SyntheticSensor, UndoingTheMotionMatters) {
  // Without it, points of a moving truck miss the ground by far more than with it.
  double largest = 0;
  const World& world = pit();
  for (std::size_t k = 0; k < world.sweeps.count; k += 20) {
    const LidarScan scan = world.scan(k);
    const Pose end = pose_at(world.trajectory, world.sweeps.end(k));
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
      if (on_object(scan, i)) continue;
      const Vector3 point = end * beam_of(scan, i);
      largest =
          std::max(largest, std::abs(point.z() - world.terrain.height_at(point.x(), point.y())));
    }
  }
  EXPECT_GT(largest, 1.0);
}

TEST(SyntheticSensor, RangeNoiseHasTheGivenDeviation) {
  PitParameters exact = small_pit();
  exact.range_noise = 0;
  const World world(exact, 7);
  const LidarScan noisy = pit().scan(3), clean = world.scan(3);
  ASSERT_EQ(noisy.points.size(), clean.points.size());
  double sum = 0;
  for (std::size_t i = 0; i < clean.points.size(); ++i) {
    const double error = beam_of(noisy, i).norm() - beam_of(clean, i).norm();
    sum += error * error;
  }
  const double deviation = std::sqrt(sum / static_cast<double>(clean.points.size()));
  EXPECT_NEAR(deviation, small_pit().range_noise, 0.1 * small_pit().range_noise);
}

TEST(SyntheticSensor, TimesGoUpToTheStamp) {
  const LidarScan scan = pit().scan(1);
  std::int32_t before = -100'000'000;
  for (const std::int32_t offset : scan.time_offset) {
    EXPECT_GE(offset, before);
    EXPECT_LE(offset, 0);
    before = offset;
  }
  EXPECT_LT(scan.time_offset.front(), -90'000'000);
  EXPECT_EQ(scan.time_offset.back(), 0);
}

TEST(SyntheticSensor, RingsHaveTheElevationsOfTheirLasers) {
  const LidarScan scan = pit().scan(1);
  const auto& elevations = pit().lidar.elevations();
  ASSERT_EQ(elevations.size(), 16u);
  for (std::size_t i = 0; i < scan.points.size(); ++i) {
    const Vector3 beam = beam_of(scan, i);
    EXPECT_NEAR(std::asin(beam.z() / beam.norm()), elevations[scan.ring[i]], 1e-5);
  }
}

TEST(SyntheticSensor, LabelsSayWhatWasHit) {
  const World& world = pit();
  std::size_t ground = 0, wall = 0, berm = 0, object = 0;
  for (std::size_t k = 0; k < world.sweeps.count; k += 10) {
    const LidarScan scan = world.scan(k);
    for (std::size_t i = 0; i < scan.points.size(); ++i) {
      const Pose pose = pose_at(world.trajectory, world.sweeps.end(k) + scan.time_offset[i]);
      const Vector3 point = pose * beam_of(scan, i);
      const auto cell = world.terrain.frame.cell_at(point.x(), point.y());
      if (!cell) continue;
      const bool drivable = world.terrain.drivable[world.terrain.frame.place(*cell)] != 0;
      switch (static_cast<PointLabel>(scan.label[i])) {
        case PointLabel::kGround:
          ++ground;
          break;
        case PointLabel::kWall:
          ++wall;
          break;
        case PointLabel::kBerm:
          ++berm;
          break;
        case PointLabel::kObject:
          // Machines stand over the ground, beside the drivable area.
          EXPECT_GT(point.z(), world.terrain.height_at(point.x(), point.y()) - 0.2);
          object += drivable ? 0 : 1;
          break;
        default:
          ADD_FAILURE() << "a point without a label";
      }
    }
  }
  EXPECT_GT(ground, 10'000u);
  EXPECT_GT(wall, 1'000u);
  EXPECT_GT(berm, 5'000u);
  EXPECT_GT(object, 30u);
}

TEST(SyntheticSensor, DropoutsTakeTheirShare) {
  PitParameters all = small_pit(), half = small_pit();
  all.dropout = 0;
  half.dropout = 0.5;
  const double kept = static_cast<double>(World(half, 7).scan(2).points.size()) /
                      static_cast<double>(World(all, 7).scan(2).points.size());
  EXPECT_NEAR(kept, 0.5, 0.03);
}

TEST(Box, IsHitOnTheSideThatFacesTheRay) {
  const Box box{{10, 0, 1}, {2, 1, 1}, 0};
  EXPECT_DOUBLE_EQ(box.cast({0, 0, 1}, {1, 0, 0}), 8);
  EXPECT_DOUBLE_EQ(box.cast({10, 5, 1}, {0, -1, 0}), 4);
  EXPECT_TRUE(std::isinf(box.cast({0, 0, 1}, {-1, 0, 0})));
  EXPECT_TRUE(std::isinf(box.cast({0, 1.5, 1}, {1, 0, 0})));
}

TEST(Noise, IsSmoothAndBounded) {
  for (double x = -3; x < 3; x += 0.01) {
    EXPECT_LE(std::abs(value_noise(9, x, 0.3)), 1);
    EXPECT_NEAR(value_noise(9, x, 0.3), value_noise(9, x + 1e-4, 0.3), 1e-3);
  }
}

}  // namespace
}  // namespace stope::source
