#include <gmock/gmock.h>

#include <cstring>
#include <limits>
#include <vector>

#include "stope/payloads.hpp"
#include "tests/plugins/source/stage_harness.hpp"
#include "tests/plugins/source/test_folder.hpp"

extern "C" const stope::StageEntry* stope_stage_Kitti();

namespace stope::source {
namespace {

using ::testing::HasSubstr;

std::string scan_of(const std::vector<float>& numbers) {
  return {reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof(float)};
}

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

class KittiTest : public ::testing::Test {
 protected:
  KittiTest() {
    folder.write("scans/000000.bin", scan_of({1, 2, 3, 0.5f, 4, 5, 6, 0.25f}));
    folder.write("scans/000001.bin", scan_of({7, 8, 9, 1}));
    poses = folder.write("poses.txt", "1 0 0 10 0 1 0 20 0 0 1 30\n0 -1 0 1 1 0 0 2 0 0 1 3\n");
    harness.set("scans", (folder.path() / "scans").string()).set("poses", poses.string());
    harness.keep("scans", scans).keep("poses", stream).keep("trajectory", trajectory);
  }

  std::string failure() {
    const Outcome outcome = harness.run();
    EXPECT_EQ(outcome.kind, Outcome::Kind::kFailed);
    return outcome.sentence;
  }

  TestFolder folder;
  std::filesystem::path poses;
  StageHarness harness{stope_stage_Kitti()};
  testing::MemoryOutput<LidarScan> scans;
  testing::MemoryOutput<StampedPose> stream;
  testing::MemoryOutput<Trajectory> trajectory;
};

TEST_F(KittiTest, ReadsScansAndPosesAtARate) {
  harness.set("rate", 4.0);
  const Outcome outcome = harness.run();
  ASSERT_TRUE(outcome) << outcome.sentence;
  ASSERT_EQ(scans.items.size(), 2u);
  EXPECT_EQ(scans.items[1].stamp, 250'000'000);
  EXPECT_EQ(scans.items[0].value->points[1], (Point3f{4, 5, 6}));
  EXPECT_EQ(scans.items[0].value->intensity[1], 0.25f);
  ASSERT_EQ(trajectory.items.size(), 1u);
  const Pose& second = trajectory.items[0].value->poses[1].T_map_lidar;
  const Vector3 moved = second * Vector3(1, 0, 0);  // a quarter turn to the left, then (1, 2, 3)
  EXPECT_NEAR(moved.x(), 1, 1e-12);
  EXPECT_NEAR(moved.y(), 3, 1e-12);
  EXPECT_EQ(stream.items[1].value->stamp, 250'000'000);
}

TEST_F(KittiTest, TakesTimesFromAFileAndAPartOfTheScans) {
  harness.set("times", folder.write("times.txt", "# seconds\n3.5\n4.75\n").string());
  harness.set("first", std::int64_t{1});
  ASSERT_TRUE(harness.run());
  ASSERT_EQ(scans.items.size(), 1u);
  EXPECT_EQ(scans.items[0].stamp, 4'750'000'000);
}

TEST_F(KittiTest, LeavesOutPointsThatAreNotFiniteAndSaysSo) {
  folder.write("scans/000001.bin", scan_of({kNan, 0, 0, 0, 1, 1, 1, kNan}));
  ASSERT_TRUE(harness.run());
  EXPECT_EQ(scans.items[1].value->points.size(), 1u);
  EXPECT_EQ(scans.items[1].value->intensity[0], 0);
  EXPECT_THAT(harness.context.sentences, ::testing::Contains(HasSubstr("1 of the 2 points of")));
}

TEST_F(KittiTest, NamesAnEmptyScan) {
  folder.write("scans/000001.bin", "");
  EXPECT_THAT(failure(), HasSubstr("000001.bin is empty"));
}

TEST_F(KittiTest, NamesATruncatedScanBeforeAnyIsRead) {
  folder.write("scans/000001.bin", "seventeen bytes..");
  EXPECT_THAT(failure(), HasSubstr("000001.bin has 17 bytes, which is not a whole number"));
  EXPECT_TRUE(scans.items.empty());
}

TEST_F(KittiTest, NamesAScanWithoutAnyFinitePoint) {
  folder.write("scans/000001.bin", scan_of({kNan, 0, 0, 0}));
  EXPECT_THAT(failure(), HasSubstr("none of the 1 points of the scan"));
}

TEST_F(KittiTest, WantsAPoseForEachScan) {
  folder.write("poses.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n");
  EXPECT_THAT(failure(), HasSubstr("has 1 poses, but"));
}

TEST_F(KittiTest, NamesTheLineOfABadPose) {
  folder.write("poses.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n\n1 0 0 0 0 1 0 0 0 0 1\n");
  EXPECT_THAT(failure(), HasSubstr("poses.txt:3: the row has 11 numbers"));
  folder.write("poses.txt", "1 0 0 0 0 1 0 zero 0 0 1 0\n");
  EXPECT_THAT(failure(), HasSubstr("poses.txt:1: \"zero\" is not a number"));
  folder.write("poses.txt", "1 0 0 0 0 1 0 nan 0 0 1 0\n");
  EXPECT_THAT(failure(), HasSubstr("is not finite"));
}

TEST_F(KittiTest, RefusesAMatrixThatIsNoRotation) {
  folder.write("poses.txt", "1 0 0 0 0 1 0 0 0 0 1 0\n1 0 0 0 0 1 0 0 0 0 -1 0\n");
  EXPECT_THAT(failure(), HasSubstr("poses.txt:2: the left 3x3 part of the pose is not a rotation"));
}

TEST_F(KittiTest, SaysWhatToGiveWhenTheMotionIsWantedButUnknown) {
  harness.set("poses", ParameterValue{});
  EXPECT_THAT(failure(), HasSubstr("give the parameter poses"));
}

TEST_F(KittiTest, RefusesAFolderWithoutScans) {
  harness.set("scans", folder.path().string());
  EXPECT_THAT(failure(), HasSubstr("holds no *.bin files"));
}

TEST_F(KittiTest, RefusesTimesThatDoNotIncrease) {
  harness.set("times", folder.write("times.txt", "2\n2\n").string());
  EXPECT_THAT(failure(), HasSubstr("times.txt:2"));
}

TEST(Kitti, ReadsARealRecording) {
  const auto recording = real_data("kitti_0005");
  if (!std::filesystem::exists(recording))
    GTEST_SKIP() << "there is no " << recording << ": set STOPE_DATA to run this test";
  StageHarness harness(stope_stage_Kitti());
  testing::MemoryOutput<LidarScan> scans;
  testing::MemoryOutput<Trajectory> trajectory;
  harness.set("scans", (recording / "scans_third").string());
  harness.set("poses", (recording / "poses_velo_in_odom.txt").string());
  const Outcome outcome = harness.keep("scans", scans).keep("trajectory", trajectory).run();
  ASSERT_TRUE(outcome) << outcome.sentence;
  EXPECT_EQ(scans.items.size(), 110u);
  EXPECT_EQ(trajectory.items[0].value->poses.size(), 110u);
  EXPECT_GT(scans.items[0].value->points.size(), 30'000u);
}

}  // namespace
}  // namespace stope::source
