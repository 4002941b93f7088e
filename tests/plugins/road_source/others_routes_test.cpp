// Route graphs that Stope did not write: drawn by hand, or made by another program.
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tests/plugins/road_source/made_roads.hpp"

namespace stope::road_source {
namespace {

using nlohmann::json;

json point(std::int64_t id, double x, double y) {
  return {{"type", "Feature"},
          {"properties", {{"id", id}, {"frame", "map"}}},
          {"geometry", {{"type", "Point"}, {"coordinates", {x, y}}}}};
}

// As nav2's own graphs have them: a MultiLineString without coordinates.
json edge(std::int64_t id, std::int64_t start, std::int64_t end) {
  return {{"type", "Feature"},
          {"properties", {{"id", id}, {"startid", start}, {"endid", end}}},
          {"geometry", {{"type", "MultiLineString"}}}};
}

std::string collection(const std::vector<json>& features) {
  return json{{"type", "FeatureCollection"}, {"name", "graph"}, {"features", features}}.dump(1);
}

TEST(OthersRoutes, OppositeEdgesAreOneRoadAndASingleOneIsOneWay) {
  const RoadGraph roads =
      read_route(collection({point(10, 0, 0), point(11, 3, 4), point(12, 9, 4), edge(1, 10, 11),
                             edge(2, 11, 10), edge(3, 12, 11)}),
                 nullptr, 6);
  ASSERT_EQ(roads.nodes.size(), 3U);
  EXPECT_EQ(roads.nodes[0].id, 10U);
  ASSERT_EQ(roads.edges.size(), 2U);
  EXPECT_EQ(roads.edges[0].direction, RoadDirection::kBoth);
  EXPECT_EQ(roads.edges[0].length, 5.0);
  EXPECT_EQ(roads.edges[0].width, 12.0);
  EXPECT_EQ(roads.edges[0].min_clearance, 6.0);
  EXPECT_EQ(roads.edges[1].direction, RoadDirection::kBackward);  // 12 is the higher node
  EXPECT_EQ(roads.edges[1].id, 3U);
  EXPECT_TRUE(std::isnan(roads.edges[1].speed_limit));
}

TEST(OthersRoutes, OppositeEdgesWithOtherLimitsStayTwoRoads) {
  json up = edge(1, 10, 11), down = edge(2, 11, 10);
  up["properties"]["metadata"] = {{"abs_speed_limit", 8.5}};
  down["properties"]["metadata"] = {{"abs_speed_limit", 5.5}};
  const RoadGraph roads = read_route(collection({point(10, 0, 0), point(11, 3, 4), up, down}));
  ASSERT_EQ(roads.edges.size(), 2U);
  EXPECT_EQ(roads.edges[0].direction, RoadDirection::kForward);
  EXPECT_EQ(roads.edges[0].speed_limit, 8.5);
  EXPECT_EQ(roads.edges[1].direction, RoadDirection::kBackward);
  EXPECT_EQ(roads.edges[1].speed_limit, 5.5);
}

TEST(OthersRoutes, ALineThatJoinsItsNodesIsKeptHoweverItWasDrawn) {
  json there = edge(1, 10, 11), elsewhere = edge(2, 10, 12);
  there["geometry"] = {{"type", "LineString"}, {"coordinates", {{6, 0}, {3, 4}, {0, 0.01}}}};
  elsewhere["geometry"] = {{"type", "MultiLineString"}, {"coordinates", {{{50, 50}, {60, 60}}}}};
  std::vector<std::string> sentences;
  const RoadGraph roads =
      read_route(collection({point(10, 0, 0), point(11, 6, 0), point(12, 0, 9), there, elsewhere}),
                 &sentences);
  ASSERT_EQ(roads.edges.size(), 2U);
  for (const RoadEdge& road : roads.edges)
    EXPECT_EQ(road.length, road.id == 1 ? 10.0 : 9.0) << road.id;
  EXPECT_NE(sentences.at(0).find("the lines of 1 edges do not run"), std::string::npos);
}

TEST(OthersRoutes, WhatARoadGraphCannotHoldIsNamed) {
  json node = point(10, 0, 0), link = edge(1, 10, 11);
  node["properties"]["operations"] = {{"stop", {{"type", "stop"}, {"trigger", "NODE"}}}};
  link["properties"]["cost"] = 10.0;
  link["properties"]["metadata"] = {{"class", "ramp"}, {"speed_limit", 85.0}};
  std::vector<std::string> sentences;
  json polygon = {{"type", "Feature"},
                  {"properties", json::object()},
                  {"geometry", {{"type", "Polygon"}, {"coordinates", json::array()}}}};
  read_route(collection({node, point(11, 1, 0), link, polygon}), &sentences);
  std::string all;
  for (const std::string& sentence : sentences) all += sentence + "\n";
  EXPECT_NE(all.find("cost (1 times), metadata.class (1 times), metadata.speed_limit (1 times), "
                     "operations (1 times)"),
            std::string::npos)
      << all;
  EXPECT_NE(all.find("1 features are neither points nor lines"), std::string::npos);
}

TEST(OthersRoutes, ALimitThatIsNoSpeedIsNamedAndLeftOut) {
  for (const double limit : {0.0, -8.0}) {
    json link = edge(1, 10, 11);
    link["properties"]["metadata"] = {{"abs_speed_limit", limit}};
    std::vector<std::string> sentences;
    const RoadGraph roads =
        read_route(collection({point(10, 0, 0), point(11, 1, 0), link}), &sentences);
    EXPECT_TRUE(std::isnan(roads.edges.at(0).speed_limit));
    EXPECT_NE(sentences.at(0).find("speed limits of 0 or less (1 times)"), std::string::npos);
  }
}

TEST(OthersRoutes, AVersionOfStopeToComeIsRefused) {
  json file = json::parse(collection({point(10, 0, 0), point(11, 1, 0), edge(1, 10, 11)}));
  file["stope"] = {{"version", 99}, {"nodes", 2}, {"roads", 1}};
  EXPECT_NE(read_error(file.dump(1)).find("version 99: this Stope reads 1 only"), std::string::npos)
      << read_error(file.dump(1));
  file["stope"].erase("version");
  EXPECT_NE(read_error(file.dump(1)).find("has the version none"), std::string::npos);
}

TEST(OthersRoutes, PlacesOffThisWorldAndEndlessNumbersGiveShortErrors) {
  const std::string far = read_error(collection({point(10, 1e308, 0)}));
  EXPECT_NE(far.find("the position (1e+308, 0) is no place in metres"), std::string::npos) << far;
  std::string text = collection({point(10, 0, 0)});
  text.replace(text.find("0.0"), 3, "1" + std::string(5000, '0'));
  const std::string endless = read_error(text);
  EXPECT_FALSE(endless.empty());
  EXPECT_LT(endless.size(), 500U);
}

TEST(OthersRoutes, WrongIdsAreNamedWithFeatureAndLine) {
  const json a = point(0, 0, 0), b = point(1, 1, 0);
  const auto error = [&](std::vector<json> features) { return read_error(collection(features)); };
  EXPECT_EQ(error({a, b, edge(5, 0, 1)}), "");
  EXPECT_NE(error({a, b, edge(5, 0, 7)})
                .find("feature 3: its endid is 7, and there is "
                      "no node of that id"),
            std::string::npos)
      << error({a, b, edge(5, 0, 7)});
  EXPECT_NE(error({a, b, a}).find("feature 3: node 0 is there already, as feature 1"),
            std::string::npos);
  EXPECT_NE(
      error({a, b, edge(5, 0, 1), edge(5, 1, 0)}).find("edge 5 is there already, as feature 3"),
      std::string::npos);
  for (const json& wrong :
       {json(-1), json(1.5), json(4294967296), json("1"), json(1e300), json()}) {
    json node = b;
    node["properties"]["id"] = wrong;
    const std::string sentence = error({a, node});
    EXPECT_NE(sentence.find("feature 2: 'id' is " + wrong.dump()), std::string::npos) << sentence;
    EXPECT_NE(sentence.find("from 0 to 4294967295"), std::string::npos) << sentence;
  }
  json without = edge(5, 0, 1);
  without["properties"].erase("endid");
  EXPECT_NE(error({a, b, without}).find("feature 3 (edge 5): 'endid' is missing"),
            std::string::npos);
  EXPECT_NE(error({a, b, without}).find(".geojson:"), std::string::npos);
}

TEST(OthersRoutes, WrongTypesAreNamed) {
  const auto changed = [](const char* pointer, const json& value) {
    json file = json::parse(collection({point(0, 0, 0), point(1, 1, 0), edge(5, 0, 1)}));
    file[json::json_pointer(pointer)] = value;
    return read_error(file.dump(1));
  };
  const auto expect = [&](const char* pointer, const json& value, const char* part) {
    const std::string sentence = changed(pointer, value);
    EXPECT_NE(sentence.find(part), std::string::npos) << pointer << ": " << sentence;
  };
  expect("/features", 3, "'features' is no list");
  expect("/features/0", 3, "feature 1: this is no feature");
  expect("/features/0/geometry", nullptr, "feature 1: 'geometry' must be an object");
  expect("/features/0/geometry/type", 5, "no 'type'");
  expect("/features/0/geometry/coordinates", {1}, "(node 0): a position");
  expect("/features/0/geometry/coordinates", {"a", 2}, "a coordinate is \"a\"");
  expect("/features/0/properties", nullptr, "'properties' must be an object");
  expect("/features/0/properties/frame", 7, "'frame' must be a text");
  expect("/features/0/properties/metadata", 7, "'metadata' must be an object");
  expect("/features/2/properties/cost", "low", "'cost' is \"low\"");
  expect("/features/2/properties/overridable", 1, "'overridable' must be true or false");
  expect("/features/2/properties/metadata", {{"abs_speed_limit", "fast"}}, "abs_speed_limit");
  expect("/features/2/geometry/coordinates", {1, 2}, "is no list");
  expect("/features/1/properties/frame", "odom", "2 frames");
}

TEST(OthersRoutes, WhatIsNotGeoJsonIsSaidSo) {
  EXPECT_NE(read_error("").find(":1: the file is empty"), std::string::npos);
  EXPECT_NE(read_error("P5 3 2").find("this is no GeoJSON"), std::string::npos);
  EXPECT_NE(read_error("[1, 2]").find("this is no GeoJSON"), std::string::npos);
  EXPECT_NE(read_error("{\"type\": \"Feature\"}").find("no list 'features'"), std::string::npos);
  EXPECT_NE(read_error("{\"features\": [\n\n{\"a\" 1}]}").find(":3: feature 1: this is not JSON"),
            std::string::npos);
  EXPECT_NE(read_error("{\"features\": []} x").find("something follows"), std::string::npos);
  EXPECT_NE(read_error("{\"features\": [{\"properties\": {\"id\": 1e999}}]}").find("feature 1"),
            std::string::npos);
  EXPECT_NE(read_error("{\"features\": [" + std::string(200000, '[')).find("cut off in feature 1"),
            std::string::npos);
  EXPECT_NE(
      read_error("{\"features\": [" + std::string(200000, '[') + std::string(200000, ']') + "]}")
          .find("feature 1"),
      std::string::npos);
  EXPECT_NE(read_error("{\"a\": \"\\").find("cut off"), std::string::npos);
}

TEST(OthersRoutes, AByteOrderMarkDoesNoHarm) {
  EXPECT_EQ(read_route("\xef\xbb\xbf" + collection({point(3, 0, 0), point(4, 1, 0), edge(5, 3, 4)}))
                .edges.size(),
            1U);
}

}  // namespace
}  // namespace stope::road_source
