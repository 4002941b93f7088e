#include <gtest/gtest.h>

#include "framework/diagnostics/diagnostic.hpp"

namespace stope {
namespace {

const std::vector<std::string> kNames{"grid", "roads", "min_clearance", "topology/voronoi"};

TEST(NearestName, FindsSlipsOfTheFinger) {
  EXPECT_EQ(nearest_name("gird", kNames), "grid");    // swapped
  EXPECT_EQ(nearest_name("grids", kNames), "grid");   // one too many
  EXPECT_EQ(nearest_name("rods", kNames), "roads");   // one missing
  EXPECT_EQ(nearest_name("rodes", kNames), "roads");  // one of each
  EXPECT_EQ(nearest_name("Min-Clearance", kNames), "min_clearance");
  EXPECT_EQ(nearest_name("topology/vornoi", kNames), "topology/voronoi");
}

TEST(NearestName, LeavesOtherWordsAlone) {
  for (const char* name : {"", "cloud", "x", "planner/a_star", "path"})
    EXPECT_EQ(nearest_name(name, kNames), "") << name;
  EXPECT_EQ(nearest_name(std::string(100'000, 'a'), kNames), "");
}

TEST(NearestName, DoesNotDependOnTheOrder) {
  EXPECT_EQ(nearest_name("cat", {"bat", "car"}), nearest_name("cat", {"car", "bat"}));
}

}  // namespace
}  // namespace stope
