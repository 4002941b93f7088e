#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/plugins/export/export_samples.hpp"
#include "tests/plugins/stage_harness.hpp"

extern "C" const stope::StageEntry* stope_stage_PathGeojson();

namespace stope::exports {
namespace {

TEST(PathGeojson, ReadsBackToTheLastBit) {
  Path path;
  path.points = {{0.1, 1e6 + 1.0 / 3, std::nan(""), 0.25, 4, 0, 0},
                 {2.5, -7, 12.125, -1, std::nan(""), 0.01, 0}};
  path.edges = {9007199254740991ULL, 5};
  path.length = 10.0 / 3;
  const auto json = nlohmann::json::parse(text_of(
      stope::testing::StageHarness(stope_stage_PathGeojson()).input("path", path).apply<Artefact>(),
      "geojson"));
  const auto& feature = json["features"][0];
  EXPECT_EQ(feature["geometry"]["type"], "LineString");
  const auto& line = feature["geometry"]["coordinates"];
  EXPECT_EQ(line[0].size(), 2U);  // without a height
  EXPECT_EQ(line[0][0].get<double>(), path.points[0].x);
  EXPECT_EQ(line[0][1].get<double>(), path.points[0].y);
  EXPECT_EQ(line[1][2].get<double>(), 12.125);
  EXPECT_EQ(feature["properties"]["length"].get<double>(), path.length);
  EXPECT_EQ(feature["properties"]["edges"].get<std::vector<std::uint64_t>>(), path.edges);
  EXPECT_EQ(feature["properties"]["yaw"][1].get<double>(), -1);
  EXPECT_TRUE(feature["properties"]["clearance"][1].is_null());
}

TEST(PathGeojson, RefusesAPathThatIsNoLine) {
  EXPECT_NE(stope::testing::error_of([] {
              stope::testing::StageHarness(stope_stage_PathGeojson())
                  .input("path", Path{})
                  .apply<Artefact>();
            }).find("fewer than two points"),
            std::string::npos);
}

}  // namespace
}  // namespace stope::exports
