#include "plugins/map/voxel_filter.hpp"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <array>
#include <cmath>
#include <map>

#include "stope/digest.hpp"
#include "stope/random.hpp"

namespace stope::map {
namespace {

std::vector<VoxelPoint> random_points(std::size_t count) {
  Random random(5);
  std::vector<VoxelPoint> points(count);
  for (VoxelPoint& point : points) {
    point.position = {static_cast<float>(random.uniform(-3, 3)),
                      static_cast<float>(random.uniform(-3, 3)),
                      static_cast<float>(random.uniform(-1, 1))};
    point.intensity = static_cast<float>(random.uniform());
    point.label = static_cast<std::uint8_t>(random.below(6));
    point.used = random.below(10) != 0;
  }
  return points;
}

TEST(VoxelFilter, GivesEachVoxelsMeanAndMostFrequentLabel) {
  const auto points = random_points(20000);
  struct Sum {
    double x = 0, y = 0, z = 0, intensity = 0, count = 0;
    std::array<int, 6> labels{};
  };
  std::map<std::array<long, 3>, Sum> truth;  // by z, y, x: the order the filter promises
  for (const VoxelPoint& point : points) {
    if (!point.used) continue;
    const auto index = [](float v) { return static_cast<long>(std::floor(v / 0.5)); };
    Sum& sum = truth[{index(point.position.z), index(point.position.y), index(point.position.x)}];
    sum.x += point.position.x, sum.y += point.position.y, sum.z += point.position.z;
    sum.intensity += point.intensity;
    ++sum.count;
    ++sum.labels[point.label];
  }
  VoxelFilter filter(0.5);
  EXPECT_EQ(filter.add(points), 0U);
  const PointCloud cloud = filter.finish(Vector3(1, 2, 3), true, true);
  ASSERT_EQ(cloud.points.size(), truth.size());
  EXPECT_EQ(cloud.origin, Vector3(1, 2, 3));
  std::size_t i = 0;
  for (const auto& [key, sum] : truth) {
    EXPECT_NEAR(cloud.points[i].x, sum.x / sum.count, 1e-5);
    EXPECT_NEAR(cloud.points[i].y, sum.y / sum.count, 1e-5);
    EXPECT_NEAR(cloud.points[i].z, sum.z / sum.count, 1e-5);
    EXPECT_NEAR(cloud.intensity[i], sum.intensity / sum.count, 1e-5);
    const auto most = std::max_element(sum.labels.begin(), sum.labels.end());
    EXPECT_EQ(cloud.label[i], most - sum.labels.begin());
    ++i;
  }
}

TEST(VoxelFilter, TheSameBytesOnAnyNumberOfThreads) {
  const auto points = random_points(50000);
  std::vector<Digest> digests;
  for (const std::size_t threads : {1U, 2U, 4U}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    VoxelFilter filter(0.1);
    filter.add(points);
    filter.add(points);
    digests.push_back(digest_of(filter.finish(Vector3::Zero(), true, true)));
  }
  EXPECT_EQ(digests[0], digests[1]);
  EXPECT_EQ(digests[0], digests[2]);
}

TEST(VoxelFilter, CountsWhatLiesTooFarAway) {
  VoxelFilter filter(0.001);
  VoxelPoint far;
  far.position = {2e3F, 0, 0};
  far.used = true;
  EXPECT_EQ(filter.add(std::vector{far}), 1U);
  EXPECT_TRUE(filter.finish(Vector3::Zero(), false, false).points.empty());
}

}  // namespace
}  // namespace stope::map
