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

TEST(PathGeojson, SaysSpeedsAndWhereTheDirectionChanges) {
  // Forwards to (2, 0), back to (1, 0) and forwards to (3, 0), always looking east.
  Path path;
  const double places[] = {0, 1, 2, 1, 3}, speeds[] = {0, 1.5, 0, 0, 0};
  for (std::size_t i = 0; i < 5; ++i) path.points.push_back({places[i], 0, 0, 0, 0, 0, speeds[i]});
  path.points.insert(path.points.begin() + 3, {1.5, 0, 0, 0, 0, 0, -1.25});
  const auto properties = [&] {
    stope::testing::StageHarness stage(stope_stage_PathGeojson());
    const auto text = text_of(stage.input("path", path).apply<Artefact>(), "geojson");
    return nlohmann::json::parse(text)["features"][0]["properties"];
  };
  EXPECT_EQ(properties()["speed"].get<std::vector<double>>(),
            (std::vector<double>{0, 1.5, 0, -1.25, 0, 0}));
  EXPECT_EQ(properties()["cusps"].get<std::vector<int>>(), (std::vector<int>{2, 4}));
  // Without speeds it is a line that nobody drives.
  for (PathPoint& point : path.points) point.speed = 0;
  EXPECT_TRUE(properties()["cusps"].empty());
}

TEST(PathGeojson, SaysWhereTheTruckStandsOnItsWay) {
  // It stands at both ends, over two points from the third on and at the seventh, where it only
  // turns its wheels.
  Path path;
  const double speeds[] = {0, 1, 0, 0, 1, 2, 0, 1, 0, 0};
  for (std::size_t i = 0; i < 10; ++i)
    path.points.push_back({static_cast<double>(i), 0, 0, 0, 0, 0, speeds[i]});
  const auto standstills = [&] {
    stope::testing::StageHarness stage(stope_stage_PathGeojson());
    const auto text = text_of(stage.input("path", path).apply<Artefact>(), "geojson");
    return nlohmann::json::parse(text)["features"][0]["properties"]["standstills"]
        .get<std::vector<int>>();
  };
  EXPECT_EQ(standstills(), (std::vector<int>{2, 6}));
  for (PathPoint& point : path.points) point.speed = 0;
  EXPECT_TRUE(standstills().empty());
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
