#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "stope/digest.hpp"
#include "tests/plugins/stage_harness.hpp"

extern "C" const stope::StageEntry* stope_stage_HeightDifference();

namespace stope::rasterizer {
namespace {

using stope::testing::StageHarness;
using Height = std::function<double(double x, double y)>;

// Points 0.2 m apart on a surface from (0, 0) to (60, 30), with a few centimetres of noise.
PointCloud cloud_of(const Height& height, const std::function<bool(double, double)>& seen = {}) {
  PointCloud cloud;
  Random random(9);
  for (double x = 0.1; x < 60; x += 0.2) {
    for (double y = 0.1; y < 30; y += 0.2) {
      if (seen && !seen(x, y)) continue;
      cloud.points.push_back({static_cast<float>(x), static_cast<float>(y),
                              static_cast<float>(height(x, y) + 0.02 * random.normal())});
    }
  }
  return cloud;
}

StageHarness rasterizer(PointCloud cloud) {
  StageHarness stage(stope_stage_HeightDifference());
  stage.input("cloud", std::move(cloud));
  return stage;
}

OccupancyGrid rasterize(PointCloud cloud) {
  return rasterizer(std::move(cloud)).apply<OccupancyGrid>();
}

std::uint8_t at(const OccupancyGrid& grid, double x, double y) {
  const auto cell = grid.frame.cell_at(x, y);
  return cell ? grid.cells[grid.frame.place(*cell)] : OccupancyGrid::kUnknown;
}

void expect_all(const OccupancyGrid& grid, double left, double bottom, double right, double top,
                std::uint8_t value, const char* what) {
  for (double x = left; x <= right; x += 0.5) {
    for (double y = bottom; y <= top; y += 0.5)
      EXPECT_EQ(at(grid, x, y), value) << what << " at " << x << ", " << y;
  }
}

// A berm 1.2 m high with its crest along y = 20, and flanks of 40 degrees.
double berm(double y) { return std::max(0.0, 1.2 - std::abs(y - 20) * 0.84); }

TEST(HeightDifference, ARampIsFreeAndItsBermIsNot) {
  for (const double grade : {0.0, 0.08, 0.12}) {
    const auto grid = rasterize(cloud_of([&](double x, double y) { return grade * x + berm(y); }));
    expect_all(grid, 2, 2, 58, 17.5, OccupancyGrid::kFree, "ramp");
    expect_all(grid, 2, 20.1, 58, 20.1, OccupancyGrid::kOccupied, "berm");
  }
}

TEST(HeightDifference, ABenchIsFreeToItsEdgeAndItsFaceIsNot) {
  // The face climbs 10 m between x = 30 and x = 33.
  const auto grid =
      rasterize(cloud_of([](double x, double) { return 10 * std::clamp((x - 30) / 3, 0.0, 1.0); }));
  expect_all(grid, 2, 2, 29, 28, OccupancyGrid::kFree, "floor");
  expect_all(grid, 30.8, 2, 32.6, 28, OccupancyGrid::kOccupied, "face");
  expect_all(grid, 35.5, 2, 58, 28, OccupancyGrid::kFree, "bench above");
}

TEST(HeightDifference, AParkedTruckIsAnObstacle) {
  // Four by eight metres; only its skin and the ground round it are seen.
  const auto inside = [](double x, double y) { return x > 20 && x < 28 && y > 10 && y < 14; };
  PointCloud cloud = cloud_of([](double, double) { return 5.0; },
                              [&](double x, double y) { return !inside(x, y); });
  for (double z = 0.5; z < 4; z += 0.2) {
    for (double x = 20; x <= 28; x += 0.2) {
      cloud.points.push_back({static_cast<float>(x), 10.05F, static_cast<float>(5 + z)});
      cloud.points.push_back({static_cast<float>(x), 13.95F, static_cast<float>(5 + z)});
    }
  }
  const auto grid = rasterize(cloud);
  expect_all(grid, 20.3, 10.2, 27.7, 10.2, OccupancyGrid::kOccupied, "near side");
  expect_all(grid, 20.3, 13.8, 27.7, 13.8, OccupancyGrid::kOccupied, "far side");
  EXPECT_NE(at(grid, 24, 12), OccupancyGrid::kFree);
  expect_all(grid, 2, 2, 18, 28, OccupancyGrid::kFree, "yard");
}

TEST(HeightDifference, UnknownIsKeptApart) {
  const auto grid = rasterize(cloud_of([](double, double) { return 0.0; },
                                       [](double x, double) { return x < 20 || x > 40; }));
  expect_all(grid, 20.6, 1, 39.4, 29, OccupancyGrid::kUnknown, "not seen");
  expect_all(grid, 1, 1, 19, 29, OccupancyGrid::kFree, "seen");
}

TEST(HeightDifference, GapsBetweenRingsAreClosedOnLevelGroundOnly) {
  const auto rings = [](double x, double) { return std::fmod(x, 2.0) < 0.7; };  // gaps of 1.3 m
  const auto level = rasterize(cloud_of([](double, double) { return 0.0; }, rings));
  expect_all(level, 1, 2, 58, 28, OccupancyGrid::kFree, "between rings");
  const auto open = rasterizer(cloud_of([](double, double) { return 0.0; }, rings))
                        .set("close_gaps", 0.0)
                        .apply<OccupancyGrid>();
  EXPECT_EQ(at(open, 31.3, 15), OccupancyGrid::kUnknown);
  // An edge of 3 m hides in a gap from x = 30 to x = 31.4: floor and bench are seen, the face is
  // not.
  const auto step = rasterize(cloud_of([](double x, double) { return x < 30.7 ? 0.0 : 3.0; },
                                       [](double x, double) { return x < 30 || x > 31.4; }));
  for (double y = 2; y < 28; y += 0.5) EXPECT_NE(at(step, 30.7, y), OccupancyGrid::kFree);
}

TEST(HeightDifference, ABermSeenWithGapsStaysClosed) {
  // Every other metre of the berm is hidden.
  const auto grid = rasterize(
      cloud_of([](double, double y) { return berm(y); },
               [](double x, double y) { return std::abs(y - 20) > 1.5 || std::fmod(x, 2) < 1; }));
  for (double x = 2; x < 58; x += 0.25) {
    bool wall = false;
    for (double y = 18; y <= 22; y += 0.25)
      wall = wall || at(grid, x, y) == OccupancyGrid::kOccupied;
    EXPECT_TRUE(wall) << x;
  }
}

TEST(HeightDifference, OnePointDeepInTheGroundOrHighUpChangesNothing) {
  PointCloud cloud = cloud_of([](double, double) { return 0.0; });
  const auto before = rasterize(cloud);
  cloud.points.push_back({20.05F, 15.05F, -8});
  cloud.points.push_back({40.05F, 15.05F, 1});
  EXPECT_EQ(rasterize(cloud).cells, before.cells);
}

TEST(HeightDifference, AnOverhangIsDrivenUnderIfAskedFor) {
  PointCloud cloud = cloud_of([](double, double) { return 0.0; });
  for (double y = 0.1; y < 30; y += 0.1) {
    for (double x = 30; x < 31; x += 0.2)
      cloud.points.push_back({static_cast<float>(x), static_cast<float>(y), 7});  // a conveyor
  }
  EXPECT_EQ(at(rasterize(cloud), 30.3, 15), OccupancyGrid::kOccupied);
  EXPECT_EQ(at(rasterizer(cloud).set("overhang", 6.0).apply<OccupancyGrid>(), 30.3, 15),
            OccupancyGrid::kFree);
}

TEST(HeightDifference, WithATrajectoryOnlyWhatCanBeReachedFromItIsKept) {
  // A berm along y = 20 with a gap of `width` metres; the route is driven below it.
  const auto open_above = [](double width) {
    Trajectory trajectory;
    for (int i = 0; i < 10; ++i) {
      StampedPose pose;
      pose.stamp = i;
      pose.T_map_lidar.translation = Vector3(5 + 5 * i, 8, 2);
      trajectory.poses.push_back(pose);
    }
    const auto grid = rasterizer(cloud_of([&](double x, double y) {
                        return std::abs(x - 30) < width / 2 ? 0.0 : berm(y);
                      }))
                          .input("trajectory", trajectory)
                          .apply<OccupancyGrid>();
    expect_all(grid, 2, 2, 58, 17, OccupancyGrid::kFree, "below the berm");
    expect_all(grid, 2, 20.1, 25, 20.1, OccupancyGrid::kOccupied, "berm");
    return at(grid, 30, 26) == OccupancyGrid::kFree;
  };
  EXPECT_FALSE(open_above(0));
  EXPECT_FALSE(open_above(3));
  EXPECT_TRUE(open_above(8));
}

TEST(HeightDifference, WhereTheVehicleDroveTheGroundIsFree) {
  // Another truck followed and left its points all along the route.
  PointCloud cloud = cloud_of([](double, double) { return 0.0; });
  Trajectory trajectory;
  trajectory.poses.resize(2);
  trajectory.poses[0].T_map_lidar.translation = Vector3(5, 15, 2);
  trajectory.poses[1].T_map_lidar.translation = Vector3(55, 15, 2);
  trajectory.poses[1].stamp = 1;
  for (double x = 5; x < 55; x += 0.2) {
    for (double y = 13; y < 17; y += 0.2)
      cloud.points.push_back({static_cast<float>(x), static_cast<float>(y), 1.5F});
  }
  EXPECT_EQ(at(rasterize(cloud), 30.25, 15.25), OccupancyGrid::kOccupied);
  const auto grid = rasterizer(cloud)
                        .input("trajectory", trajectory)
                        .set("driven_width", 3.0)
                        .apply<OccupancyGrid>();
  expect_all(grid, 6, 14, 54, 16, OccupancyGrid::kFree, "route");
  EXPECT_EQ(at(grid, 30.25, 13.25), OccupancyGrid::kOccupied);
}

TEST(HeightDifference, ATrajectoryElsewhereIsReportedAndLosesNothing) {
  Trajectory trajectory;
  trajectory.poses.resize(1);
  trajectory.poses[0].T_map_lidar.translation = Vector3(500, 500, 0);
  auto stage = rasterizer(cloud_of([](double, double) { return 0.0; }));
  const auto grid = stage.input("trajectory", trajectory).apply<OccupancyGrid>();
  expect_all(grid, 2, 2, 58, 28, OccupancyGrid::kFree, "level ground");
  ASSERT_EQ(stage.context().sentences.size(), 1U);
  EXPECT_NE(stage.context().sentences[0].find("does not touch the cloud's area"),
            std::string::npos);
}

TEST(HeightDifference, SmearedGroundStaysGround) {
  // Poses that err in height lay the road over itself in layers, 0.5 m from lowest to highest.
  PointCloud cloud;
  for (const double layer : {-0.3, -0.1, 0.0, 0.05, 0.1, 0.15, 0.2}) {
    const PointCloud one = cloud_of([&](double, double y) { return layer + berm(y); });
    cloud.points.insert(cloud.points.end(), one.points.begin(), one.points.end());
  }
  const auto grid = rasterize(cloud);
  expect_all(grid, 2, 2, 58, 17, OccupancyGrid::kFree, "road");
  expect_all(grid, 2, 20.1, 58, 20.1, OccupancyGrid::kOccupied, "berm");
}

TEST(HeightDifference, FarFromZeroTheGridLiesWhereThePointsAre) {
  PointCloud cloud = cloud_of([](double, double y) { return berm(y); });
  const auto near = rasterize(cloud);
  cloud.origin = Vector3(431'000, 4'512'000, 100);
  const auto far = rasterize(cloud);
  EXPECT_EQ(near.cells, far.cells);
  EXPECT_EQ(far.frame.origin.x - near.frame.origin.x, 431'000);
}

TEST(HeightDifference, TheSameBytesOnAnyNumberOfThreads) {
  const PointCloud cloud = cloud_of([](double x, double y) { return 0.05 * x + berm(y); });
  std::vector<Digest> digests;
  for (const std::size_t threads : {1U, 2U, 4U}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    digests.push_back(digest_of(rasterize(cloud)));
  }
  EXPECT_EQ(digests[0], digests[1]);
  EXPECT_EQ(digests[0], digests[2]);
}

TEST(HeightDifference, BrokenCloudsAreRefused) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  PointCloud broken;
  broken.points.assign(10, {nan, nan, nan});
  EXPECT_NE(stope::testing::error_of([&] { rasterize(broken); }).find("no finite point"),
            std::string::npos);
  EXPECT_NE(stope::testing::error_of([&] { rasterize({}); }).find("no finite point"),
            std::string::npos);
  broken.points = {{0, 0, 0}, {1e9F, 1e9F, 0}};
  EXPECT_NE(stope::testing::error_of([&] { rasterize(broken); }).find("points far off?"),
            std::string::npos);
}

}  // namespace
}  // namespace stope::rasterizer
