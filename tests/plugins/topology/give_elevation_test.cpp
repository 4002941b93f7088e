#include "plugins/topology/give_elevation.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "stope/error.hpp"

namespace stope::topology {
namespace {

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();

/// One straight road.
RoadGraph road(Vector2 from, Vector2 to) {
  RoadGraph graph;
  graph.nodes = {{0, from.x(), from.y(), kUnknown}, {0, to.x(), to.y(), kUnknown}};
  graph.vertices = {{from.x(), from.y(), kUnknown, 5}, {to.x(), to.y(), kUnknown, 7}};
  RoadEdge edge;
  edge.from = 0, edge.to = 1, edge.first_vertex = 0, edge.vertex_count = 2;
  graph.edges = {edge};
  canonicalize(graph);
  return graph;
}

/// A ground whose height is a function of the place in the map.
template <class Height>
ElevationGrid ground(const GridFrame& frame, Height height) {
  ElevationGrid grid{frame, {}, {}};
  for (std::int32_t row = 0; row < frame.height; ++row) {
    for (std::int32_t column = 0; column < frame.width; ++column) {
      const Vector2 centre = frame.centre({column, row});
      grid.cells.push_back(static_cast<float>(height(centre.x(), centre.y())));
    }
  }
  return grid;
}

/// Another origin, resolution and direction than any map here has.
const GridFrame kTurned{160, 120, 1.5, {-40, -60, 0.4}};

TEST(GiveElevation, APlaneIsReadExactlyFromAnyFrame) {
  const auto plane = [](double x, double y) { return 3 + 0.06 * x - 0.02 * y; };
  RoadGraph roads = road({0, 0}, {80, 40});
  give_elevation(roads, ground(kTurned, plane));
  for (const RoadNode& node : roads.nodes) EXPECT_NEAR(node.z, plane(node.x, node.y), 1e-4);
  for (const RoadVertex& vertex : roads.vertices)
    EXPECT_NEAR(vertex.z, plane(vertex.x, vertex.y), 1e-4);
  EXPECT_EQ(roads.vertices.size(), 2U) << "a plane needs no vertex in between";
  const double length = std::hypot(80, 40);
  EXPECT_NEAR(roads.edges[0].grade, (0.06 * 80 - 0.02 * 40) / length, 1e-5);
}

TEST(GiveElevation, ARampBetweenTwoVerticesIsFound) {
  // Flat, then one in ten over 30 m, then flat.
  const auto ramp = [](double x, double) { return 0.1 * std::clamp(x - 20, 0.0, 30.0); };
  RoadGraph roads = road({0, 0}, {80, 0});
  give_elevation(roads, ground(kTurned, ramp));
  EXPECT_NEAR(roads.edges[0].grade, 0.1, 0.005);
  EXPECT_GE(roads.vertices.size(), 4U);
  EXPECT_LE(roads.vertices.size(), 8U);
  for (int i = 0; i <= 80; ++i) {
    const auto line = roads.polyline(roads.edges[0]);
    for (std::size_t k = 1; k < line.size(); ++k) {
      if (line[k].x < i || line[k - 1].x > i) continue;
      const double share = (i - line[k - 1].x) / (line[k].x - line[k - 1].x);
      EXPECT_NEAR(line[k - 1].z + share * (line[k].z - line[k - 1].z), ramp(i, 0), 0.2);
      EXPECT_NEAR(line[k - 1].clearance + share * (line[k].clearance - line[k - 1].clearance),
                  5 + 2 * i / 80.0, 1e-9);
    }
  }
}

TEST(GiveElevation, BeyondTheGroundAndBesideUnknownCellsNothingIsKnown) {
  const GridFrame frame{20, 20, 1.0, {0, 0, 0}};
  RoadGraph roads = road({-30, 5.5}, {15.5, 5.5});
  ElevationGrid grid = ground(frame, [](double x, double) { return 0.05 * x; });
  give_elevation(roads, grid);
  EXPECT_TRUE(std::isnan(roads.nodes[0].z));
  EXPECT_NEAR(roads.nodes[1].z, 0.775, 1e-6);
  EXPECT_NEAR(roads.edges[0].grade, 0.05, 1e-3) << "measured where it is known";
  EXPECT_LE(roads.vertices.size(), 5U);

  grid.cells[grid.frame.place({10, 5})] = std::numeric_limits<float>::quiet_NaN();
  RoadGraph across = road({2.5, 5.5}, {17.5, 5.5});
  give_elevation(across, grid);
  bool unknown = false;
  for (const RoadVertex& vertex : across.vertices) unknown = unknown || std::isnan(vertex.z);
  EXPECT_TRUE(unknown);
  EXPECT_FALSE(std::isnan(across.nodes[0].z));
}

TEST(GiveElevation, NothingElseChanges) {
  const RoadGraph before = road({0, 0}, {80, 0});
  RoadGraph after = before;
  give_elevation(after, ground(kTurned, [](double x, double y) { return std::sin(0.2 * x) + y; }));
  ASSERT_EQ(after.edges.size(), 1U);
  EXPECT_EQ(after.nodes[0].id, before.nodes[0].id);
  EXPECT_EQ(after.edges[0].id, before.edges[0].id);
  EXPECT_NEAR(after.edges[0].length, before.edges[0].length, 1e-9);
  EXPECT_NEAR(after.edges[0].mean_clearance, before.edges[0].mean_clearance, 1e-9);
  EXPECT_EQ(after.edges[0].min_clearance, before.edges[0].min_clearance);
}

TEST(GiveElevation, GridsThatContradictThemselvesAreRefused) {
  const auto refusal = [](const ElevationGrid& grid) -> std::string {
    RoadGraph roads = road({0, 0}, {5, 0});
    try {
      give_elevation(roads, grid);
    } catch (const Error& error) {
      return error.what();
    }
    return {};
  };
  EXPECT_NE(refusal({}).find("the elevation grid is empty"), std::string::npos);
  ElevationGrid grid = ground({2, 2, 1.0, {}}, [](double, double) { return 0; });
  grid.cells.pop_back();
  EXPECT_NE(refusal(grid).find("holds 3"), std::string::npos);
  for (const double resolution : {0.0, -2.0, kUnknown, 1e-9, 1e9})
    EXPECT_NE(refusal(ground({2, 2, resolution, {}}, [](double, double) { return 0; }))
                  .find("resolution"),
              std::string::npos);
}

}  // namespace
}  // namespace stope::topology
