#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "tests/plugins/export/export_samples.hpp"
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

// nav2's loader fails on metadata that is neither number, text, truth nor a list or object of them.
void expect_loadable(const json& metadata) {
  for (const auto& [key, value] : metadata.items()) {
    EXPECT_FALSE(value.is_null()) << key;
    if (value.is_object()) expect_loadable(value);
  }
}

TEST(Nav2Route, IdsAreUniqueOverNodesAndEdges) {
  const json route = route_of(sample_roads());
  EXPECT_EQ(route["type"], "FeatureCollection");
  std::set<std::uint64_t> node_ids, edge_ids;
  for (const json& feature : route["features"]) {
    const json& properties = feature["properties"];
    const bool node = feature["geometry"]["type"] == "Point";
    EXPECT_TRUE((node ? node_ids : edge_ids).insert(properties["id"].get<std::uint64_t>()).second);
    expect_loadable(properties["metadata"]);
    if (node) {
      EXPECT_EQ(properties["frame"], "map");
    }
  }
  // 3 nodes and 2 in the curve; 2 edges of the straight road, 3 of the one-way curve.
  EXPECT_EQ(node_ids, (std::set<std::uint64_t>{0, 1, 2, 3, 4}));
  EXPECT_EQ(edge_ids, (std::set<std::uint64_t>{5, 6, 7, 8, 9}));
}

TEST(Nav2Route, ChainsJoinAgainIntoTheRoadsTheyCameFrom) {
  const RoadGraph graph = sample_roads();
  const json route = route_of(graph);
  std::map<std::uint64_t, Vector2> places;
  std::map<std::uint64_t, std::map<std::uint64_t, Vector2>> curves;
  for (const json& feature : route["features"]) {
    const json& properties = feature["properties"];
    if (feature["geometry"]["type"] == "Point") {
      const auto& at = feature["geometry"]["coordinates"];
      const Vector2 place(at[0].get<double>(), at[1].get<double>());
      places[properties["id"].get<std::uint64_t>()] = place;
      const json& stope = properties["metadata"]["stope"];
      if (stope.contains("edge"))
        curves[stope["edge"].get<std::uint64_t>()][stope["seq"].get<std::uint64_t>()] = place;
    }
  }
  ASSERT_EQ(curves.size(), 1U);
  for (const RoadEdge& edge : graph.edges) {
    if (edge.direction != RoadDirection::kForward) continue;
    const auto line = graph.polyline(edge);
    ASSERT_EQ(curves[edge.id].size(), line.size() - 2);
    for (std::size_t i = 1; i + 1 < line.size(); ++i)
      EXPECT_EQ(curves[edge.id][i], Vector2(line[i].x, line[i].y));
  }
  std::multiset<std::pair<std::uint64_t, std::uint64_t>> joined;
  double cost = 0;
  for (const json& feature : route["features"]) {
    if (feature["geometry"]["type"] != "LineString") continue;
    const json& properties = feature["properties"];
    const auto from = properties["startid"].get<std::uint64_t>();
    const auto to = properties["endid"].get<std::uint64_t>();
    joined.insert({from, to});
    EXPECT_EQ(feature["geometry"]["coordinates"][0][0], places.at(from).x());
    EXPECT_EQ(feature["geometry"]["coordinates"][1][1], places.at(to).y());
    if (properties["metadata"].contains("abs_speed_limit")) {
      EXPECT_EQ(properties["metadata"]["abs_speed_limit"], 8.25);
      cost += properties["cost"].get<double>();
    }
  }
  EXPECT_EQ(joined.count({0, 1}), 1U);
  EXPECT_EQ(joined.count({1, 0}), 1U);
  EXPECT_EQ(joined.count({1, 2}) + joined.count({2, 1}), 0U);  // closed
  EXPECT_EQ(joined.count({0, 3}) + joined.count({3, 4}) + joined.count({4, 2}), 3U);
  EXPECT_EQ(joined.count({3, 0}), 0U);  // one-way
  EXPECT_NEAR(cost, std::hypot(10, 20) + std::hypot(10, 14) + std::hypot(10.25, 6), 1e-9);
}

TEST(Nav2Route, ToleranceShortensChains) {
  EXPECT_EQ(route_of(sample_roads(), 100)["features"].size(), 3U + 2U + 1U);
}

TEST(Nav2Route, AGraphWithoutEdgesIsRefusedAsNav2RefusesIt) {
  const auto sentence = stope::testing::error_of([] { route_of(RoadGraph{}); });
  EXPECT_NE(sentence.find("no edges, and nav2 refuses"), std::string::npos);
  RoadGraph closed = sample_roads();
  for (RoadEdge& edge : closed.edges) edge.closed = 1;
  EXPECT_NE(stope::testing::error_of([&] { route_of(closed); }).find("closed"), std::string::npos);
}

}  // namespace
}  // namespace stope::exports
