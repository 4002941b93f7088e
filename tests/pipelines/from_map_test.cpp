#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "small_map.hpp"
#include "stope_process.hpp"

namespace stope::testing {
namespace {

const std::string kFromMap = shipped("pipelines/haul_roads/from_map.yaml");

ProcessResult run_on(const std::filesystem::path& map, const std::filesystem::path& out,
                     std::vector<std::string> more = {}) {
  std::vector<std::string> arguments{"run",   kFromMap,    "--set", "vars.map=" + map.string(),
                                     "--out", out.string()};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return stope(arguments);
}

TEST(FromMap, GivesARoadGraphAndAPath) {
  const TemporaryFolder folder;
  const auto result = run_on(write_ring_map(folder.path()), folder.path() / "run");
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const auto roads = nlohmann::json::parse(read_file(folder.path() / "run/outputs/roads.geojson"));
  EXPECT_EQ(roads.at("type"), "FeatureCollection");
  EXPECT_GT(roads.at("features").size(), 3U);
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "run/report.html"));
  EXPECT_TRUE(output_digests(folder.path() / "run").contains("outputs/overview.png") ||
              output_digests(folder.path() / "run").contains("overview.png"));
}

TEST(FromMap, DrivesBetweenTheGivenPlaces) {
  const TemporaryFolder folder;
  const auto result = run_on(write_ring_map(folder.path()), folder.path() / "run",
                             {"--set", "vars.start=[15, 40]", "--set", "vars.goal=[105, 40]"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const auto plan = nlohmann::json::parse(read_file(folder.path() / "run/outputs/plan.geojson"));
  const auto points = plan.at("features").at(0).at("geometry").at("coordinates");
  // The only ways from west to east follow the ring and then the dead-end road at y = 40.
  EXPECT_NEAR(points.front().at(0).get<double>(), 15, 2);
  EXPECT_NEAR(points.back().at(0).get<double>(), 105, 2);
  EXPECT_NEAR(points.back().at(1).get<double>(), 40, 2);
}

TEST(FromMap, AMapWithoutAFreeCellIsRefused) {
  const TemporaryFolder folder;
  const auto result =
      run_on(write_small_map(folder.path(), "solid", 20, 20, {}), folder.path() / "run");
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.err.find("roads"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("no free cell"), std::string::npos) << result.err;
}

TEST(FromMap, AStartOffTheMapNamesTheNearestReachablePlace) {
  const TemporaryFolder folder;
  const auto result = run_on(write_ring_map(folder.path()), folder.path() / "run",
                             {"--set", "vars.start=[-500, 40]", "--set", "vars.goal=[105, 40]"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.err.find("start"), std::string::npos) << result.err;
  EXPECT_NE(result.err.find("nearest"), std::string::npos) << result.err;
}

TEST(FromMap, AGoalThatCannotBeReachedNamesTheNearestReachablePlace) {
  const TemporaryFolder folder;
  const auto map =
      write_small_map(folder.path(), "two", 120, 80, {{10, 10, 110, 20}, {10, 50, 110, 60}});
  const auto result = run_on(map, folder.path() / "run",
                             {"--set", "vars.start=[20, 15]", "--set", "vars.goal=[60, 55]"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.err.find("nearest"), std::string::npos) << result.err;
}

TEST(FromMap, AFailedRunKeepsTheOutputsOfTheRunBefore) {
  const TemporaryFolder folder;
  const auto map = write_ring_map(folder.path());
  ASSERT_EQ(run_on(map, folder.path() / "run").exit_code, 0);
  const std::string before = read_file(folder.path() / "run/outputs/roads.geojson");
  EXPECT_EQ(run_on(map, folder.path() / "run",
                   {"--set", "vars.start=[-500, 40]", "--set", "vars.goal=[105, 40]"})
                .exit_code,
            1);
  EXPECT_EQ(read_file(folder.path() / "run/outputs/roads.geojson"), before);
}

// Counted over undirected edges of the written file, by Euler: edges - nodes + components.
long cycles_of(const std::filesystem::path& geojson) {
  const auto graph = nlohmann::json::parse(read_file(geojson));
  std::map<long, long> parent;
  const auto root = [&](long node) {
    while (parent.at(node) != node) node = parent.at(node);
    return node;
  };
  long cycles = 0;
  for (const auto& feature : graph.at("features")) {
    if (feature.at("geometry").at("type") == "Point")
      parent[feature.at("properties").at("id")] = feature.at("properties").at("id");
  }
  for (const auto& feature : graph.at("features")) {
    if (feature.at("geometry").at("type") == "Point") continue;
    const long from = feature.at("properties").at("startid"),
               to = feature.at("properties").at("endid");
    if (from > to) continue;  // each undirected edge is written once a direction
    const long a = root(from), b = root(to);
    cycles += a == b ? 1 : 0;
    parent[a] = b;
  }
  return cycles;
}

TEST(FromMap, TheRealMineKeepsOneCycleForEachLargeHole) {
  if (data_folder().empty())
    GTEST_SKIP() << "This test needs the open-pit map in STOPE_DATA, which is not there.";
  const TemporaryFolder folder;
  for (const char* member : {"topology/voronoi", "topology/watershed"}) {
    const auto result =
        run_on(data_folder() / "open_pit_maps/dapai_0p5m.yaml", folder.path() / "run",
               {"--set", std::string("roads.use=") + member});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(cycles_of(folder.path() / "run/outputs/roads.geojson"), 7) << member;
  }
}

}  // namespace
}  // namespace stope::testing
