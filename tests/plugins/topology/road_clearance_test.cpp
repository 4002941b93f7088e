// Clearances of roads against all obstacle cells, looked at every twentieth of a cell.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "plugins/topology/extract_roads.hpp"
#include "tests/plugins/topology/test_grids.hpp"

namespace stope::topology {
namespace {

class AllObstacles {
 public:
  explicit AllObstacles(const OccupancyGrid& grid) : resolution_(grid.frame.resolution) {
    for (std::int32_t row = -1; row <= grid.frame.height; ++row)
      for (std::int32_t column = -1; column <= grid.frame.width; ++column)
        if (!grid.frame.contains({column, row}) ||
            grid.cells[grid.frame.place({column, row})] != OccupancyGrid::kFree)
          centres_.push_back(grid.frame.to_map(column + 0.5, row + 0.5));
  }
  double clearance(double x, double y) const {
    double least = 1e18;
    for (const Vector2& centre : centres_)
      least = std::min(least, (centre - Vector2(x, y)).squaredNorm());
    return std::max(0.0, std::sqrt(least) - 0.5 * resolution_);
  }

 private:
  double resolution_;
  std::vector<Vector2> centres_;
};

void expect_clearances_along_lines(const OccupancyGrid& grid, const RoadGraph& roads) {
  const AllObstacles obstacles(grid);
  const double cell = grid.frame.resolution;
  for (const RoadEdge& edge : roads.edges) {
    double least = 1e18, area = 0;
    const auto line = roads.polyline(edge);
    for (const RoadVertex& vertex : line)
      EXPECT_NEAR(vertex.clearance, obstacles.clearance(vertex.x, vertex.y), 1e-6 * cell);
    for (std::size_t i = 1; i < line.size(); ++i) {
      const double dx = line[i].x - line[i - 1].x, dy = line[i].y - line[i - 1].y;
      const double length = std::hypot(dx, dy);
      const int parts = static_cast<int>(20 * length / cell) + 1;
      for (int k = 0; k < parts; ++k) {
        const double part = (k + 0.5) / parts;
        const double here =
            obstacles.clearance(line[i - 1].x + part * dx, line[i - 1].y + part * dy);
        least = std::min(least, here);
        area += length / parts * here;
      }
    }
    // A truck relies on it: it may be the least between two places looked at, but never more.
    EXPECT_LE(edge.min_clearance, least + 1e-5 * cell)
        << "from " << line.front().x << ", " << line.front().y;
    EXPECT_GE(edge.min_clearance, least - 0.03 * cell);
    const double mean = area / edge.length;
    EXPECT_NEAR(edge.mean_clearance, mean, std::max(0.1 * mean, 0.5 * cell));
  }
}

TEST(RoadClearance, IsTheLeastAlongTheWholeLineOfRoughRoads) {
  std::size_t roads_seen = 0;
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    // Walls come up to 2 m nearer than the road's half width of 7 m.
    const std::vector<Stretch> lines{
        {{15, 20}, {85, 20}}, {{50, 20}, {50, 70}}, {{20, 65}, {80, 65}}};
    const OccupancyGrid grid = grid_where(100, 85, 0.5, [&](double x, double y) {
      return distance_to(lines, {x, y}) <= 7 + 2 * roughness(x, y, 0.5, seed);
    });
    BranchParams branches;
    for (const bool medial : {false, true}) {
      ExtractionParams params;
      params.medial_lines = medial;
      params.min_obstacle_area = 0;
      for (const RoadGraph& roads :
           {voronoi_roads(grid, params, branches), skeleton_roads(grid, params, branches, {})}) {
        expect_clearances_along_lines(grid, roads);
        roads_seen += roads.edges.size();
      }
    }
  }
  EXPECT_GT(roads_seen, 70U);
}

TEST(RoadClearance, IsTheLeastBetweenVerticesFarApart) {
  // A straight road of 20 m with one cell of obstacle reaching into it from each side.
  const OccupancyGrid grid = grid_where(140, 40, 0.5, [](double x, double y) {
    const bool post = std::abs(x - 47.3) < 0.4 || std::abs(x - 91.1) < 0.4;
    return x > 10 && x < 130 && y > 10 && y < 30 && !(post && std::abs(y - 20) > 6);
  });
  const RoadGraph roads = voronoi_roads(grid, {}, {});
  ASSERT_EQ(roads.edges.size(), 1U);
  expect_clearances_along_lines(grid, roads);
  EXPECT_NEAR(roads.edges[0].min_clearance, 6, 0.5);
}

// Cells cut off from the obstacle nearest to them, and obstacles nearest to places between cells
// alone: clearances were up to 2.5 cells more than the truth.
TEST(RoadClearance, IsNeverOverstatedAmongRandomSpecks) {
  std::size_t roads_seen = 0;
  for (std::uint64_t seed = 1; seed <= 9; ++seed) {
    const double free = seed % 3 == 0 ? 0.7 : seed % 3 == 1 ? 0.95 : 0.995;
    const OccupancyGrid grid = random_grid(90, 70, free, 1, seed);
    for (const bool medial : {false, true}) {
      ExtractionParams params;
      params.medial_lines = medial;
      params.min_obstacle_area = 0;
      params.min_clearance = 0;
      for (const RoadGraph& roads :
           {voronoi_roads(grid, params, {}), watershed_roads(grid, params)}) {
        expect_clearances_along_lines(grid, roads);
        roads_seen += roads.edges.size();
      }
    }
  }
  EXPECT_GT(roads_seen, 5000U);
}

}  // namespace
}  // namespace stope::topology
