#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/plugins/export/export_samples.hpp"
#include "tests/plugins/export/nav2_rules.hpp"
#include "tests/plugins/stage_harness.hpp"

extern "C" const stope::StageEntry* stope_stage_Nav2Route();

namespace stope::exports {
namespace {

using nlohmann::json;
using stope::testing::StageHarness;

json route_of(RoadGraph graph, double tolerance = 0) {
  return json::parse(text_of(StageHarness(stope_stage_Nav2Route())
                                 .input("roads", std::move(graph))
                                 .set("tolerance", tolerance)
                                 .apply<Artefact>(),
                             "geojson"));
}

std::string error_of(const RoadGraph& graph) {
  return stope::testing::error_of([&] { route_of(graph); });
}

std::size_t place_of_closed(const RoadGraph& graph) {
  for (std::size_t i = 0; i < graph.edges.size(); ++i) {
    if (graph.edges[i].closed != 0) return i;
  }
  return graph.edges.size();
}

TEST(Nav2Route, Nav2LoadsTheOpenRoadsAndNothingElse) {
  const json route = route_of(sample_roads());
  EXPECT_EQ(route["type"], "FeatureCollection");
  const Nav2Graph loaded = load_as_nav2(route);
  EXPECT_EQ(loaded.complaints, std::vector<std::string>{});
  // 3 nodes and 2 in the curve; 2 edges of the straight road, 3 of the one-way curve.
  EXPECT_EQ(loaded.nodes.size(), 5U);
  EXPECT_EQ(loaded.edges.size(), 5U);
  std::multiset<std::pair<std::uint32_t, std::uint32_t>> joined;
  double cost = 0;
  for (const auto& edge : loaded.edges) {
    joined.insert({edge.start, edge.end});
    if (edge.abs_speed_limit == 8.25) cost += edge.cost;
  }
  using Joined = std::multiset<std::pair<std::uint32_t, std::uint32_t>>;
  EXPECT_EQ(joined, (Joined{{0, 1}, {1, 0}, {0, 3}, {3, 4}, {4, 2}}));  // 1-2 is closed
  EXPECT_NEAR(cost, std::hypot(10, 20) + std::hypot(10, 14) + std::hypot(10.25, 6), 1e-9);
}

TEST(Nav2Route, ClosedRoadsAreInTheFileWhereNav2DoesNotLook) {
  const RoadGraph graph = sample_roads();
  const RoadEdge& closed = graph.edges.at(place_of_closed(graph));
  int found = 0;
  const json route = route_of(graph);
  for (const json& feature : route["features"]) {
    if (feature["geometry"]["type"] != "GeometryCollection") continue;
    ++found;
    EXPECT_EQ(feature["properties"]["stope"]["edge"], closed.id);
    EXPECT_EQ(feature["properties"]["startid"], closed.from);
    const json& line = feature["geometry"]["geometries"][0]["coordinates"];
    ASSERT_EQ(line.size(), 2U);
    EXPECT_EQ(line[1][1], 40.0);
  }
  EXPECT_EQ(found, 1);
}

TEST(Nav2Route, ANodeWithoutOpenRoadsIsNoGoalForNav2) {
  RoadGraph graph = sample_roads();
  graph.nodes.push_back({44, 100, 100, 7});
  EXPECT_EQ(load_as_nav2(route_of(graph)).nodes.size(), 5U);
  EXPECT_EQ(route_of(graph)["stope"]["nodes"], 4);
}

// nav2's scorers ask for a float, and its loader makes whole numbers integers.
TEST(Nav2Route, AWholeSpeedLimitIsStillAFloat) {
  RoadGraph graph = sample_roads();
  for (RoadEdge& edge : graph.edges) edge.speed_limit = 8;
  const Nav2Graph loaded = load_as_nav2(route_of(graph));
  EXPECT_EQ(loaded.complaints, std::vector<std::string>{});
  EXPECT_EQ(loaded.edges.at(0).abs_speed_limit, 8.0);
}

TEST(Nav2Route, ToleranceShortensNav2sChains) {
  const Nav2Graph loaded = load_as_nav2(route_of(sample_roads(), 100));
  EXPECT_EQ(loaded.nodes.size(), 3U);
  EXPECT_EQ(loaded.edges.size(), 3U);
  // The cost is the length of the road, not of the chord.
  double longest = 0;
  for (const auto& edge : loaded.edges) longest = std::max(longest, edge.cost);
  EXPECT_NEAR(longest, std::hypot(10, 20) + std::hypot(10, 14) + std::hypot(10.25, 6), 1e-9);
}

TEST(Nav2Route, AGraphWithoutEdgesIsRefusedAsNav2RefusesIt) {
  EXPECT_NE(error_of(RoadGraph{}).find("no edges, and nav2 refuses"), std::string::npos);
  RoadGraph closed = sample_roads();
  for (RoadEdge& edge : closed.edges) edge.closed = 1;
  EXPECT_NE(error_of(closed).find("closed"), std::string::npos);
}

TEST(Nav2Route, RefusesWhatCouldNotBeReadBack) {
  RoadGraph graph = sample_roads();
  graph.nodes[1].id = graph.nodes[0].id;
  EXPECT_NE(error_of(graph).find("two nodes of the road graph have the id"), std::string::npos);
  graph = sample_roads();
  graph.edges[1].id = graph.edges[0].id;
  EXPECT_NE(error_of(graph).find("two roads of the road graph have the id"), std::string::npos);
  graph = sample_roads();
  graph.nodes[2].x = std::nan("");
  EXPECT_NE(error_of(graph).find("which is no place"), std::string::npos);
  graph = sample_roads();
  graph.edges[0].to = 77;
  EXPECT_NE(error_of(graph).find("joins nodes"), std::string::npos);
  graph = sample_roads();
  graph.edges[0].vertex_count = 1000;
  EXPECT_NE(error_of(graph).find("no line"), std::string::npos);
}

TEST(Nav2Route, WarnsWhereNav2sFloatsAreTooCoarse) {
  RoadGraph graph = sample_roads();
  for (RoadNode& node : graph.nodes) node.x += 500000, node.y += 4e6;
  for (RoadVertex& vertex : graph.vertices) vertex.x += 500000, vertex.y += 4e6;
  StageHarness stage(stope_stage_Nav2Route());
  stage.input("roads", graph).apply<Artefact>();
  bool warned = false;
  for (const std::string& sentence : stage.context().sentences)
    warned |= sentence.find("32-bit floats") != std::string::npos;
  EXPECT_TRUE(warned);
}

}  // namespace
}  // namespace stope::exports
