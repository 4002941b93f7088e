#include <gtest/gtest.h>

#include "plugins/topology/extract_roads.hpp"
#include "tests/plugins/topology/everything.hpp"
#include "tests/plugins/topology/graph_checks.hpp"
#include "tests/plugins/topology/test_grids.hpp"

namespace stope::topology {
namespace {

TEST(DegenerateGrids, OneFreeCellIsOnePlace) {
  for (const auto& rows : {std::vector<std::string>{"."}, {"###", "#.#", "###"}}) {
    const RoadGraph roads = voronoi_roads(grid_of(rows), everything(), {});
    ASSERT_EQ(roads.nodes.size(), 1U);
    EXPECT_TRUE(roads.edges.empty());
    EXPECT_DOUBLE_EQ(roads.nodes[0].x, static_cast<double>(rows.size()) / 2);
    EXPECT_TRUE(watershed_roads(grid_of(rows), everything()).nodes.empty());
  }
}

TEST(DegenerateGrids, ARowOfFreeCellsIsARoad) {
  const std::string row(40, '.');
  const RoadGraph roads = voronoi_roads(grid_of({row}), everything(), {});
  ASSERT_EQ(roads.edges.size(), 1U);
  EXPECT_GT(roads.edges[0].length, 34.0);
  EXPECT_DOUBLE_EQ(roads.edges[0].min_clearance, 0.5);
  for (const RoadVertex& vertex : roads.vertices) EXPECT_DOUBLE_EQ(vertex.y, 0.5);
  const RoadGraph column =
      voronoi_roads(grid_of(std::vector<std::string>(40, ".")), everything(), {});
  EXPECT_NEAR(column.edges.at(0).length, roads.edges[0].length, 1e-9);
}

TEST(DegenerateGrids, AFreeSquareIsOnePlaceInItsMiddle) {
  const RoadGraph roads =
      voronoi_roads(grid_of(std::vector<std::string>(31, std::string(31, '.'))), everything(), {});
  ASSERT_EQ(roads.nodes.size(), 1U);
  EXPECT_NEAR(roads.nodes[0].x, 15.5, 1.0);
  EXPECT_NEAR(roads.nodes[0].y, 15.5, 1.0);
}

TEST(DegenerateGrids, ARingWithoutJunctionHasANode) {
  const OccupancyGrid grid = grid_where(60, 60, 0.5, [](double x, double y) {
    const double radius = std::hypot(x - 30, y - 30);
    return radius > 12 && radius < 20;
  });
  for (const RoadGraph& roads :
       {watershed_roads(grid, {}), voronoi_roads(grid, {}, {}), skeleton_roads(grid, {}, {}, {}),
        watershed_part_roads(grid, {}, {}, {})}) {
    ASSERT_EQ(roads.nodes.size(), 1U);
    ASSERT_EQ(roads.edges.size(), 1U);
    EXPECT_EQ(roads.edges[0].from, roads.edges[0].to);
    EXPECT_NEAR(roads.edges[0].length, 2 * 3.14159265 * 16, 1.0);
    EXPECT_NEAR(roads.edges[0].width, 8.0, 0.3);
  }
}

TEST(DegenerateGrids, UnknownCellsAreObstaclesUnlessToldOtherwise) {
  const OccupancyGrid grid = grid_of({std::string(12, '?') + std::string(30, '.')});
  ExtractionParams params = everything();
  EXPECT_LT(voronoi_roads(grid, params, {}).edges.at(0).length, 30.0);
  params.unknown_is_obstacle = false;
  EXPECT_GT(voronoi_roads(grid, params, {}).edges.at(0).length, 34.0);
}

TEST(DegenerateGrids, PiecesEachHaveTheirRoad) {
  const std::string row(30, '.'), wall(30, '#');
  const RoadGraph roads = voronoi_roads(grid_of({row, wall, row, wall, row}), everything(), {});
  EXPECT_EQ(betti_of(roads), (Betti{3, 0}));
  EXPECT_EQ(roads.edges.size(), 3U);
}

TEST(DegenerateGrids, FreeCellsThatTouchAtACornerAreConnected) {
  const OccupancyGrid grid = grid_of({"........########",  //
                                      "########........"});
  const RoadGraph roads = voronoi_roads(grid, everything(), {});
  EXPECT_EQ(betti_of(roads), (Betti{1, 0}));
  ASSERT_EQ(roads.edges.size(), 1U);
}

}  // namespace
}  // namespace stope::topology
