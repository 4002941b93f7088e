// What export/nav2_route writes, read back.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "plugins/export/route_writer.hpp"
#include "stope/digest.hpp"
#include "tests/plugins/road_source/made_roads.hpp"

namespace stope::road_source {
namespace {

using nlohmann::json;

std::string written(const RoadGraph& graph, double tolerance = 0) {
  return exports::route_geojson(graph, {"map", tolerance});
}

bool warns(const std::vector<std::string>& sentences, const std::string& of) {
  for (const std::string& sentence : sentences) {
    if (sentence.find(of) != std::string::npos) return true;
  }
  return false;
}

/// Changes the features that `change` says yes to; removes those it says no to.
template <class Change>
std::string edited(const std::string& text, Change&& change) {
  json file = json::parse(text);
  json kept = json::array();
  for (json& feature : file["features"]) {
    if (change(feature)) kept.push_back(feature);
  }
  file["features"] = kept;
  return file.dump();
}

TEST(Nav2RouteBack, EveryGraphComesBackToTheLastBit) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    const RoadGraph graph = made_roads(seed);
    for (const double tolerance : {0.0, 0.05, 15.0}) {
      std::vector<std::string> sentences;
      const RoadGraph back = read_route(written(graph, tolerance), &sentences);
      EXPECT_EQ(digest_of(back), digest_of(graph)) << "seed " << seed << ", " << tolerance << " m";
      EXPECT_FALSE(warns(sentences, ".geojson")) << sentences.at(0);
    }
  }
}

TEST(Nav2RouteBack, WhatMayBeDrivenOnARoadComesBackOpenOrClosed) {
  const double unknown = std::numeric_limits<double>::quiet_NaN();
  RoadGraph graph;
  for (int i = 0; i < 3; ++i) graph.nodes.push_back({0, 100.0 * i, 5, unknown});
  for (const auto direction :
       {RoadDirection::kBoth, RoadDirection::kForward, RoadDirection::kBackward})
    for (const std::uint32_t closed : {0U, 1U})
      for (const double limit : {unknown, 8.0, 11.25})
        for (const double lane : {unknown, 9.0, 4.5}) {
          RoadEdge edge;
          edge.from = closed, edge.to = closed + 1;
          edge.first_vertex = static_cast<std::uint32_t>(graph.vertices.size());
          edge.vertex_count = 3;
          // Each takes a way of its own, so that none stands in for another.
          const double off = 3.0 + static_cast<double>(graph.edges.size());
          const double x = 100.0 * closed;
          for (const auto& [dx, dy] : {std::pair(0.0, 5.0), {50.0, 5 + off}, {100.0, 5.0}})
            graph.vertices.push_back({x + dx, dy, unknown, 6});
          edge.width = 12;
          edge.direction = direction, edge.closed = closed;
          edge.speed_limit = limit, edge.lane_width = lane;
          graph.edges.push_back(edge);
        }
  canonicalize(graph);
  const RoadGraph back = read_route(written(graph));
  const auto same = [](double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); };
  ASSERT_EQ(back.edges.size(), 54U);
  for (std::size_t i = 0; i < back.edges.size(); ++i) {
    const RoadEdge &now = back.edges[i], &before = graph.edges[i];
    EXPECT_EQ(now.id, before.id);
    EXPECT_EQ(now.direction, before.direction);
    EXPECT_EQ(now.closed, before.closed);
    EXPECT_TRUE(same(now.speed_limit, before.speed_limit)) << now.speed_limit;
    EXPECT_TRUE(same(now.lane_width, before.lane_width)) << now.lane_width;
  }
}

TEST(Nav2RouteBack, AnotherProgramMayReorderAndReformatTheFile) {
  const RoadGraph graph = made_roads(7);
  json file = json::parse(written(graph));
  json& features = file["features"];
  std::reverse(features.begin(), features.end());
  EXPECT_EQ(digest_of(read_route(file.dump(4))), digest_of(graph));
}

TEST(Nav2RouteBack, AMovedNodeTakesItsRoadsAlong) {
  const RoadGraph graph = made_roads(3);
  std::vector<std::string> sentences;
  const std::string text = edited(written(graph), [](json& feature) {
    if (feature["properties"].value("id", -1) == 0) feature["geometry"]["coordinates"][0] = -600.0;
    return true;
  });
  const RoadGraph back = read_route(text, &sentences);
  EXPECT_EQ(back.edges.size(), graph.edges.size());
  EXPECT_EQ(back.nodes.at(0).x, -600.0);
  EXPECT_TRUE(warns(sentences, "were moved since")) << sentences.at(0);
}

TEST(Nav2RouteBack, ARoadDeletedWholeIsGoneWithAWarning) {
  const RoadGraph graph = made_roads(5);
  const std::uint64_t gone = json::parse(written(graph))["features"]
                                 .back()["properties"]["stope"]["edge"]
                                 .get<std::uint64_t>();
  std::vector<std::string> sentences;
  const RoadGraph back = read_route(
      edited(written(graph),
             [&](json& feature) {
               return feature["properties"].value("stope", json::object()).value("edge", json()) !=
                      json(gone);
             }),
      &sentences);
  EXPECT_EQ(back.edges.size() + 1, graph.edges.size());
  EXPECT_TRUE(warns(sentences, "Stope wrote 60 roads")) << sentences.at(0);
}

// One curved road both ways: features 1 and 2 its nodes, 3 and 4 its bends, 5 to 10 its parts.
std::string one_road() {
  RoadGraph graph;
  graph.nodes = {{0, 0, 0, 1}, {0, 30, 0, 1}};
  graph.vertices = {{0, 0, 1, 5}, {10, 5, 1, 5}, {20, 5, 1, 5}, {30, 0, 1, 5}};
  RoadEdge edge;
  edge.to = 1, edge.vertex_count = 4;
  graph.edges = {edge};
  canonicalize(graph);
  return written(graph);
}

TEST(Nav2RouteBack, AMissingPartOfARoadIsNamed) {
  const std::string text = one_road();
  ASSERT_EQ(json::parse(text)["features"].size(), 10U);
  const auto without = [&](std::size_t feature) {
    json file = json::parse(text);
    file["features"].erase(feature - 1);
    return read_error(file.dump(1));
  };
  EXPECT_NE(without(1).find("is 0, and there is no node of that id"), std::string::npos);
  EXPECT_NE(without(3).find("there is no node of that id"), std::string::npos) << without(3);
  EXPECT_NE(without(5).find("says what the road is like, is missing"), std::string::npos);
  EXPECT_NE(without(8).find("6 parts (each in both directions), and 5 are there"),
            std::string::npos)
      << without(8);
}

TEST(Nav2RouteBack, AnEndThatIsNoNodeIsNamedWhereItStands) {
  // Its opposite, which is sound, does not join the same nodes then: that is not what is wrong.
  for (const char* key : {"startid", "endid"}) {
    bool changed = false;
    const std::string text = edited(written(made_roads(4)), [&](json& feature) {
      if (!changed && feature["geometry"]["type"] == "LineString")
        feature["properties"][key] = 4000000, changed = true;
      return true;
    });
    const std::string said = read_error(text);
    EXPECT_NE(said.find("its " + std::string(key) + " is 4000000, and there is no node of that id"),
              std::string::npos)
        << said;
  }
}

TEST(Nav2RouteBack, PartsThatNoLongerFitAreNamed) {
  const auto changed = [&](std::size_t feature, const char* pointer, const json& value) {
    json file = json::parse(one_road());
    file["features"][feature - 1][json::json_pointer(pointer)] = value;
    return read_error(file.dump(1));
  };
  EXPECT_NE(changed(7, "/properties/startid", 1).find("same nodes as edge 6"), std::string::npos);
  EXPECT_NE(changed(7, "/properties/metadata/stope/seq", 3).find("expected part 2"),
            std::string::npos);
  EXPECT_NE(changed(7, "/properties/metadata/abs_speed_limit", 3.5).find("abs_speed_limit"),
            std::string::npos);
  EXPECT_NE(changed(4, "/properties/metadata/stope/seq", 1).find("not the bend 2"),
            std::string::npos);
  EXPECT_NE(changed(5, "/properties/metadata/stope/first", json::array()).find("one or four"),
            std::string::npos);
  EXPECT_NE(changed(5, "/properties/metadata/stope/width", "wide").find("width is \"wide\""),
            std::string::npos);
  EXPECT_NE(changed(5, "/properties/metadata/stope/edge", -1).find("below 2^64"),
            std::string::npos);
  EXPECT_NE(changed(5, "/properties/metadata", "{}").find("save objects as text"),
            std::string::npos);
}

TEST(Nav2RouteBack, ARoadDrawnOntoABendIsRefusedWithAWayOut) {
  json file = json::parse(one_road());
  file["features"].push_back({{"type", "Feature"},
                              {"properties", {{"id", 99}, {"startid", 2}, {"endid", 0}}},
                              {"geometry", {{"type", "LineString"}}}});
  const std::string sentence = read_error(file.dump());
  EXPECT_NE(sentence.find("which is a bend of the road"), std::string::npos) << sentence;
}

TEST(Nav2RouteBack, AFileCutOffAnywhereIsAnErrorThatNamesALine) {
  const std::string text = written(made_roads(2, 6, 4), 0.05);
  for (std::size_t length = 0; length + 2 < text.size(); length += 61) {
    const std::string sentence = read_error(text.substr(0, length));
    EXPECT_NE(sentence.find(".geojson:"), std::string::npos) << length << ": " << sentence;
  }
}

TEST(Nav2RouteBack, ThirtyThousandNodesComeBack) {
  RoadGraph graph;
  constexpr std::uint32_t kSide = 174;
  for (std::uint32_t i = 0; i < kSide * kSide; ++i)
    graph.nodes.push_back({i + 1, 10.0 * (i % kSide), 10.0 * (i / kSide) + 0.1, 1});
  for (std::uint32_t i = 0; i + 1 < kSide * kSide; ++i) {
    RoadEdge edge;
    edge.id = i + 1;
    edge.from = i, edge.to = i + 1;
    edge.first_vertex = static_cast<std::uint32_t>(graph.vertices.size());
    edge.vertex_count = 2;
    for (const std::uint32_t end : {i, i + 1})
      graph.vertices.push_back({graph.nodes[end].x, graph.nodes[end].y, 1, 3});
    graph.edges.push_back(edge);
  }
  canonicalize(graph);
  EXPECT_EQ(digest_of(read_route(written(graph))), digest_of(graph));
}

}  // namespace
}  // namespace stope::road_source
