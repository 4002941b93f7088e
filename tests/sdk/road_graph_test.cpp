#include "stope/payloads/road_graph.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace stope
