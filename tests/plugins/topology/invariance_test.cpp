#include <gtest/gtest.h>

#include "plugins/topology/extract_roads.hpp"
#include "tests/plugins/topology/graph_checks.hpp"
#include "tests/plugins/topology/test_grids.hpp"

namespace stope::topology {
namespace {

OccupancyGrid pit() {
  const std::vector<Stretch> roads{{{20, 30}, {150, 40}},   {{150, 40}, {140, 120}},
                                   {{140, 120}, {40, 110}}, {{40, 110}, {20, 30}},
                                   {{90, 35}, {80, 114}},   {{140, 120}, {175, 150}},
                                   {{40, 110}, {25, 150}}};
  return grid_where(200, 160, 0.5, [&](double x, double y) {
    return distance_to(roads, {x, y}) <= 6 + 0.7 * roughness(x, y, 0.4, 5);
  });
}

OccupancyGrid turned(const OccupancyGrid& grid) {
  OccupancyGrid result = grid;
  std::swap(result.frame.width, result.frame.height);
  for (std::int32_t row = 0; row < grid.frame.height; ++row)
    for (std::int32_t column = 0; column < grid.frame.width; ++column)
      result.cells[result.frame.place({grid.frame.height - 1 - row, column})] =
          grid.cells[grid.frame.place({column, row})];
  return result;
}

OccupancyGrid flipped(const OccupancyGrid& grid) {
  OccupancyGrid result = grid;
  for (std::int32_t row = 0; row < grid.frame.height; ++row)
    for (std::int32_t column = 0; column < grid.frame.width; ++column)
      result.cells[grid.frame.place({grid.frame.width - 1 - column, row})] =
          grid.cells[grid.frame.place({column, row})];
  return result;
}

/// Same nodes by degree and, to a cell, by place, and the same length of roads.
void expect_same(const RoadGraph& a, const RoadGraph& b, const std::function<Point(Point)>& map) {
  ASSERT_EQ(a.nodes.size(), b.nodes.size());
  ASSERT_EQ(a.edges.size(), b.edges.size());
  const std::vector<int> of_a = degrees_of(a), of_b = degrees_of(b);
  for (std::size_t i = 0; i < a.nodes.size(); ++i) {
    const Point wanted = map({a.nodes[i].x, a.nodes[i].y});
    const bool found = [&] {
      for (std::size_t k = 0; k < b.nodes.size(); ++k)
        if (of_a[i] == of_b[k] &&
            std::hypot(b.nodes[k].x - wanted.x, b.nodes[k].y - wanted.y) < 0.75)
          return true;
      return false;
    }();
    EXPECT_TRUE(found) << "node at " << wanted.x << ", " << wanted.y;
  }
  double length_a = 0, length_b = 0;
  for (const RoadEdge& edge : a.edges) length_a += edge.length;
  for (const RoadEdge& edge : b.edges) length_b += edge.length;
  EXPECT_NEAR(length_a, length_b, 0.005 * length_a);
}

TEST(Invariance, AQuarterTurnTurnsTheRoads) {
  const OccupancyGrid grid = pit();
  const auto turn = [](Point p) { return Point{160 - p.y, p.x}; };
  expect_same(voronoi_roads(grid, {}, {}), voronoi_roads(turned(grid), {}, {}), turn);
}

TEST(Invariance, AMirrorMirrorsTheRoads) {
  const OccupancyGrid grid = pit();
  const auto flip = [](Point p) { return Point{200 - p.x, p.y}; };
  expect_same(voronoi_roads(grid, {}, {}), voronoi_roads(flipped(grid), {}, {}), flip);
}

TEST(Invariance, AWatershedKeepsItsLengthWhenTurned) {
  // Its junctions are those of the loops only; a ring's node may be anywhere on it.
  const OccupancyGrid grid = pit();
  const RoadGraph a = watershed_roads(grid, {}), b = watershed_roads(turned(grid), {});
  expect_same(a, b, [](Point p) { return Point{160 - p.y, p.x}; });
}

TEST(Invariance, TheFramePlacesTheRoads) {
  OccupancyGrid grid = pit();
  const RoadGraph before = voronoi_roads(grid, {}, {});
  grid.frame.origin = {1000, -500, 0.3};
  const RoadGraph after = voronoi_roads(grid, {}, {});
  expect_same(before, after, [](Point p) {
    return Point{1000 + std::cos(0.3) * p.x - std::sin(0.3) * p.y,
                 -500 + std::sin(0.3) * p.x + std::cos(0.3) * p.y};
  });
}

}  // namespace
}  // namespace stope::topology
