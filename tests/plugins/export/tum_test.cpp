#include <gtest/gtest.h>

#include <sstream>

#include "tests/plugins/export/export_samples.hpp"
#include "tests/plugins/stage_harness.hpp"

extern "C" const stope::StageEntry* stope_stage_Tum();

namespace stope::exports {
namespace {

TEST(Tum, ReadsBackToTheLastBit) {
  Trajectory trajectory;
  trajectory.poses.resize(2);
  trajectory.poses[0].stamp = -1'500'000'001;
  trajectory.poses[1].stamp = 1'723'456'789'012'345'678;
  trajectory.poses[1].T_map_lidar.translation = Vector3(1.0 / 3, -2, 1e7 + 0.1);
  trajectory.poses[1].T_map_lidar.rotation = Quaternion(0.5, -0.5, 0.5, -0.5);
  std::istringstream text(text_of(stope::testing::StageHarness(stope_stage_Tum())
                                      .input("trajectory", trajectory)
                                      .apply<Artefact>(),
                                  "tum"));
  std::string line;
  ASSERT_TRUE(std::getline(text, line));
  EXPECT_EQ(line, "-1.500000001 0 0 0 0 0 0 1");
  ASSERT_TRUE(std::getline(text, line));
  std::istringstream fields(line);
  std::string stamp;
  double x, y, z, qx, qy, qz, qw;
  ASSERT_TRUE(fields >> stamp >> x >> y >> z >> qx >> qy >> qz >> qw);
  EXPECT_EQ(stamp, "1723456789.012345678");
  EXPECT_EQ(x, 1.0 / 3);
  EXPECT_EQ(z, 1e7 + 0.1);
  EXPECT_EQ(qx, -0.5);
  EXPECT_EQ(qw, 0.5);
}

}  // namespace
}  // namespace stope::exports
