#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <limits>

#include "stope/digest.hpp"
#include "tests/plugins/stage_harness.hpp"

extern "C" const stope::StageEntry* stope_stage_PointCloud();

namespace stope::map {
namespace {

using stope::testing::MemoryInput;
using stope::testing::MemoryOutput;
using stope::testing::StageHarness;

struct Result {
  PointCloud cloud;
  std::vector<std::string> sentences;
};

using Scans = std::vector<std::pair<Stamp, LidarScan>>;

Result join(const Scans& scans, const Trajectory& trajectory, double voxel = 0.05,
            bool compensate = true) {
  StageHarness stage(stope_stage_PointCloud());
  MemoryInput<LidarScan> scan_input;
  MemoryInput<Trajectory> trajectory_input;
  MemoryOutput<PointCloud> output;
  for (const auto& [stamp, scan] : scans) scan_input.add(stamp, scan);
  trajectory_input.add(0, trajectory);
  stage.set("voxel", voxel).set("compensate", compensate);
  stage.connect_input("scans", scan_input).connect_input("trajectory", trajectory_input);
  stage.connect_output("cloud", output).run();
  return {*output.items.at(0).value, stage.context().sentences};
}

std::string error_of(const Scans& scans, const Trajectory& trajectory) {
  return stope::testing::error_of([&] { join(scans, trajectory); });
}

// A curve driven at 12 m/s while turning at 0.5 rad/s, from x = start.
Trajectory drive(double start, double seconds) {
  Trajectory trajectory;
  for (double t = 0; t <= seconds + 1e-9; t += 0.01) {
    StampedPose pose;
    pose.stamp = stamp_from_seconds(t);
    pose.T_map_lidar.translation = Vector3(start + 12 * t, 3 * t * t, 2);
    pose.T_map_lidar.rotation = Quaternion(Eigen::AngleAxisd(0.5 * t, Eigen::Vector3d::UnitZ()));
    trajectory.poses.push_back(pose);
  }
  return trajectory;
}

// A sweep of the posts of a fence, each seen at its own time.
LidarScan sweep(const Trajectory& trajectory, Stamp stamp, const std::vector<Vector3>& posts) {
  LidarScan scan;
  for (std::size_t i = 0; i < posts.size(); ++i) {
    const auto offset = static_cast<std::int32_t>(
        -100'000'000LL * static_cast<long>(posts.size() - 1 - i) / static_cast<long>(posts.size()));
    const Vector3 seen = pose_at(trajectory, stamp + offset).inverse() * posts[i];
    scan.points.push_back(
        {static_cast<float>(seen.x()), static_cast<float>(seen.y()), static_cast<float>(seen.z())});
    scan.time_offset.push_back(offset);
  }
  return scan;
}

std::vector<Vector3> fence(double start) {
  std::vector<Vector3> posts;
  for (int i = 0; i < 40; ++i) posts.emplace_back(start + i + 0.025, 20.025, 0.025 + 0.1 * i);
  return posts;
}

TEST(PointCloud, MotionDuringTheSweepIsUndone) {
  const Trajectory trajectory = drive(0, 1);
  const auto posts = fence(0);
  Scans scans;
  for (const double t : {0.3, 0.6, 0.9})
    scans.emplace_back(stamp_from_seconds(t), sweep(trajectory, stamp_from_seconds(t), posts));
  const PointCloud cloud = join(scans, trajectory).cloud;
  ASSERT_EQ(cloud.points.size(), posts.size());
  for (std::size_t i = 0; i < posts.size(); ++i) {
    EXPECT_NEAR(cloud.points[i].x, posts[i].x(), 1e-3);
    EXPECT_NEAR(cloud.points[i].y, posts[i].y(), 1e-3);
    EXPECT_NEAR(cloud.points[i].z, posts[i].z(), 1e-3);
  }
  EXPECT_GT(join(scans, trajectory, 0.05, false).cloud.points.size(), posts.size() * 3 / 2);
}

TEST(PointCloud, FarFromZeroNothingIsLost) {
  const double start = 4'512'345;
  const Trajectory trajectory = drive(start, 0.5);
  const auto posts = fence(start);
  const Stamp stamp = stamp_from_seconds(0.4);
  const PointCloud cloud = join({{stamp, sweep(trajectory, stamp, posts)}}, trajectory).cloud;
  EXPECT_EQ(cloud.origin, Vector3(4'512'000, 0, 0));
  ASSERT_EQ(cloud.points.size(), posts.size());
  for (std::size_t i = 0; i < posts.size(); ++i)
    EXPECT_NEAR(cloud.origin.x() + cloud.points[i].x, posts[i].x(), 1e-3);
}

TEST(PointCloud, TheSameBytesOnAnyNumberOfThreads) {
  const Trajectory trajectory = drive(0, 1);
  Random random(1);
  std::vector<Vector3> posts;
  for (int i = 0; i < 30000; ++i)
    posts.emplace_back(random.uniform(-40, 40), random.uniform(-40, 40), random.uniform(0, 3));
  Scans scans;
  for (const double t : {0.2, 0.5, 0.8})
    scans.emplace_back(stamp_from_seconds(t), sweep(trajectory, stamp_from_seconds(t), posts));
  std::vector<Digest> digests;
  for (const std::size_t threads : {1U, 2U, 4U}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    digests.push_back(digest_of(join(scans, trajectory, 0.3).cloud));
  }
  EXPECT_EQ(digests[0], digests[1]);
  EXPECT_EQ(digests[0], digests[2]);
}

TEST(PointCloud, BrokenScansAreCountedAndLoseNothingElse) {
  const Trajectory trajectory = drive(0, 1);
  const Stamp stamp = stamp_from_seconds(0.5);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  LidarScan good = sweep(trajectory, stamp, fence(0));
  good.points.push_back({nan, 1, 1});
  good.points.push_back({0.1F, 0, 0});     // the truck itself
  good.points.push_back({5000.0F, 0, 0});  // a ghost
  good.time_offset.resize(good.points.size(), 0);
  LidarScan all_nan;
  all_nan.points.assign(100, {nan, nan, nan});
  const Result result = join({{stamp, good},
                              {stamp + 1, LidarScan{}},
                              {stamp + 2, all_nan},
                              {stamp_from_seconds(9), good}},
                             trajectory);
  EXPECT_EQ(result.cloud.points.size(), 40U);
  ASSERT_EQ(result.sentences.size(), 4U);
  EXPECT_EQ(result.sentences[0], "1 of 4 scans have no points");
  EXPECT_EQ(result.sentences[1], "101 of 143 points are not finite and are left out");
  EXPECT_EQ(result.sentences[2], "1 of 4 scans lie outside the trajectory's time and are left out");
}

TEST(PointCloud, IntensityAndLabelsComeAlongWhereAllScansHaveThem) {
  const Trajectory trajectory = drive(0, 1);
  const Stamp stamp = stamp_from_seconds(0.5);
  LidarScan scan = sweep(trajectory, stamp, fence(0));
  scan.intensity.assign(scan.points.size(), 0.5F);
  scan.label.assign(scan.points.size(), 3);
  const PointCloud cloud = join({{stamp, scan}}, trajectory).cloud;
  EXPECT_EQ(cloud.intensity, std::vector<float>(40, 0.5F));
  EXPECT_EQ(cloud.label, std::vector<std::uint8_t>(40, 3));
  LidarScan bare = sweep(trajectory, stamp + 1, fence(0));
  EXPECT_TRUE(join({{stamp, scan}, {stamp + 1, bare}}, trajectory).cloud.label.empty());
}

TEST(PointCloud, SaysWhyNothingRemains) {
  const Trajectory trajectory = drive(0, 1);
  EXPECT_EQ(error_of({}, trajectory), "there was no scan, so there is no map");
  EXPECT_NE(error_of({{1, LidarScan{}}}, trajectory).find("1 scans are empty"), std::string::npos);
  EXPECT_NE(error_of({{1, LidarScan{}}}, Trajectory{}).find("no poses"), std::string::npos);
  LidarScan crooked = sweep(trajectory, 0, fence(0));
  crooked.time_offset.pop_back();
  EXPECT_EQ(error_of({{0, crooked}}, trajectory),
            "the scan at 0.000 s has 40 points but 39 times: its source gave it wrongly");
}

}  // namespace
}  // namespace stope::map
