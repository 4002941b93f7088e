#include "stope/payloads/road_graph.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "stope/digest.hpp"

namespace stope {
namespace {

// An L of two roads: (0,0) - (3,0) - (3,4), told in the given order and directions.
RoadGraph corner(bool swapped) {
  RoadGraph graph;
  graph.nodes = {{0, 0, 0, 0}, {0, 3, 0, 0}, {0, 3, 4, 0}};
  graph.vertices = {{0, 0, 0, 2}, {3, 0, 0, 1}, {3, 0, 0, 1}, {3, 4, 0, 3}};
  RoadEdge first, second;
  first.from = 0, first.to = 1, first.first_vertex = 0, first.vertex_count = 2;
  second.from = 1, second.to = 2, second.first_vertex = 2, second.vertex_count = 2;
  graph.edges = {first, second};
  if (swapped) {
    std::swap(graph.nodes[0], graph.nodes[2]);
    graph.edges[0].from = 2;
    graph.edges[1].to = 0;
    std::swap(graph.vertices[2], graph.vertices[3]);
    std::swap(graph.edges[1].from, graph.edges[1].to);
    std::swap(graph.edges[0], graph.edges[1]);
  }
  canonicalize(graph);
  return graph;
}

TEST(RoadGraph, IsTheSameHoweverItWasTold) {
  EXPECT_EQ(digest_of(corner(false)), digest_of(corner(true)));
}

TEST(RoadGraph, MeasuresItsEdges) {
  const RoadGraph graph = corner(true);
  ASSERT_EQ(graph.edges.size(), 2U);
  EXPECT_DOUBLE_EQ(graph.edges[0].length, 3);
  EXPECT_DOUBLE_EQ(graph.edges[1].length, 4);
  EXPECT_DOUBLE_EQ(graph.edges[1].min_clearance, 1);
  EXPECT_DOUBLE_EQ(graph.edges[1].mean_clearance, 2);
  EXPECT_NE(graph.edges[0].id, 0U);
  EXPECT_NE(graph.edges[0].id, graph.edges[1].id);
}

// One road along the given vertices.
RoadEdge road_along(const std::vector<RoadVertex>& vertices) {
  RoadGraph graph;
  graph.nodes = {{0, vertices.front().x, vertices.front().y, vertices.front().z},
                 {0, vertices.back().x, vertices.back().y, vertices.back().z}};
  graph.vertices = vertices;
  RoadEdge edge;
  edge.from = 0, edge.to = 1, edge.first_vertex = 0;
  edge.vertex_count = static_cast<std::uint32_t>(vertices.size());
  graph.edges = {edge};
  canonicalize(graph);
  return graph.edges[0];
}

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

TEST(RoadGraph, GradeIsTheSteepestTenMetres) {
  // 4 m up over 50 m, 1 m down over 20 m.
  EXPECT_NEAR(road_along({{0, 0, 0, 2}, {50, 0, 4, 2}, {70, 0, 3, 2}}).grade, 0.08, 1e-12);
  // A kerb of half a metre counts as five in a hundred, wherever it lies between vertices.
  for (const double x : {0.0, 7.3, 33.0})
    EXPECT_NEAR(
        road_along({{-20, 0, 0, 2}, {x, 0, 0, 2}, {x + 0.01, 0, 0.5, 2}, {60, 0, 0.5, 2}}).grade,
        0.05, 1e-9);
}

TEST(RoadGraph, GradeOfAShortRoadIsThatOfItsWholeLength) {
  EXPECT_NEAR(road_along({{0, 0, 7, 2}, {3, 4, 6, 2}}).grade, 0.2, 1e-12);
}

TEST(RoadGraph, GradeIsUnknownWithoutHeightsAndMeasuredWhereTheyAreKnown) {
  EXPECT_TRUE(std::isnan(road_along({{0, 0, kUnknown, 2}, {50, 0, kUnknown, 2}}).grade));
  EXPECT_NEAR(road_along({{0, 0, kUnknown, 2}, {50, 0, 1, 2}, {90, 0, 3, 2}}).grade, 0.05, 1e-12);
  // What a file says of a road without heights is kept.
  RoadGraph graph = corner(false);
  for (RoadVertex& vertex : graph.vertices) vertex.z = kUnknown;
  graph.edges[0].grade = 0.07;
  canonicalize(graph);
  EXPECT_EQ(graph.edges[0].grade, 0.07);
}

TEST(RoadGraph, CurvatureIsThatOfTheTightestTenMetres) {
  EXPECT_EQ(road_along({{0, 0, 0, 2}, {30, 0, 0, 2}, {60, 0, 0, 2}}).curvature, 0);
  std::vector<RoadVertex> bend{{-40, 15, 0, 2}};
  for (int degrees = 0; degrees <= 180; degrees += 6) {
    const double angle = degrees * 3.14159265358979 / 180;
    bend.push_back({15 * std::sin(angle), 15 * std::cos(angle), 0, 2});
  }
  bend.push_back({-40, -15, 0, 2});
  EXPECT_NEAR(road_along(bend).curvature, 1.0 / 15, 0.002);
  // A right angle: the circle through 5 m before, the corner, and 5 m behind it.
  EXPECT_NEAR(road_along({{0, 0, 0, 2}, {20, 0, 0, 2}, {20, 20, 0, 2}}).curvature,
              std::sqrt(2.0) / 5, 1e-9);
}

TEST(RoadGraph, ATurnBackOnItselfIsAsTightAsTheLengthCanTell) {
  EXPECT_NEAR(road_along({{0, 0, 0, 2}, {20, 0, 0, 2}, {0, 0, 0, 2}}).curvature, 2.0 / 5, 1e-9);
}

}  // namespace
}  // namespace stope
