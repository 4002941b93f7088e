#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "plugins/source/synthetic_pit/curve.hpp"
#include "plugins/source/synthetic_pit/route.hpp"
#include "plugins/source/synthetic_pit/truth.hpp"
#include "tests/plugins/source/pit_worlds.hpp"

namespace stope::source {
namespace {

/// Truth is checked on whole mines, each made once.
class SyntheticTruth : public ::testing::TestWithParam<int> {
 protected:
  SyntheticTruth()
      : world(GetParam() == 0 ? yard() : small_pit(), static_cast<std::uint64_t>(GetParam())),
        grid(true_grid(world.terrain)),
        roads(true_roads(world.graph, world.terrain)) {}

  bool is_free(const Vector2& place) const {
    const auto cell = grid.frame.cell_at(place.x(), place.y());
    return cell && grid.cells[grid.frame.place(*cell)] == OccupancyGrid::kFree;
  }

  /// Metres from a place in a direction to the first obstacle.
  double free_way(const Vector2& from, const Vector2& direction) const {
    double way = 0;
    while (way < 80 && is_free(from + way * direction)) way += 0.05;
    return way;
  }

  std::vector<int> degrees() const {
    std::vector<int> degree(roads.nodes.size());
    for (const RoadEdge& edge : roads.edges) ++degree[edge.from], ++degree[edge.to];
    return degree;
  }

  World world;
  OccupancyGrid grid;
  RoadGraph roads;
};

TEST_P(SyntheticTruth, CentreLinesAreMidwayBetweenObstaclesInRoadSections) {
  std::size_t checked = 0;
  for (const RoadEdge& edge : roads.edges) {
    const auto line = roads.polyline(edge);
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
      const Vector2 place(line[i].x, line[i].y);
      const bool in_road = std::all_of(
          roads.nodes.begin(), roads.nodes.end(),
          [&](const RoadNode& node) { return (Vector2(node.x, node.y) - place).norm() > 45; });
      if (!in_road) continue;
      const Vector2 ahead =
          Vector2(line[i + 1].x - line[i - 1].x, line[i + 1].y - line[i - 1].y).normalized();
      const Vector2 left(-ahead.y(), ahead.x());
      const double half = 0.5 * edge.width, cell = grid.frame.resolution;
      EXPECT_NEAR(free_way(place, left), half, 0.8 * cell);
      EXPECT_NEAR(free_way(place, -left), half, 0.8 * cell);
      EXPECT_NEAR(line[i].clearance, half, 0.8 * cell);
      ++checked;
    }
  }
  if (GetParam() != 0) {
    EXPECT_GT(checked, 200u);
  }
}

TEST_P(SyntheticTruth, RoadsAreFreeAndConnected) {
  for (const RoadVertex& vertex : roads.vertices) {
    EXPECT_TRUE(is_free({vertex.x, vertex.y}));
    EXPECT_GT(vertex.clearance, 0.4 * world.layout.network.streets[0].width);
  }
  std::vector<std::size_t> root(roads.nodes.size());
  for (std::size_t i = 0; i < root.size(); ++i) root[i] = i;
  const auto find = [&](std::size_t i) {
    while (root[i] != i) i = root[i];
    return i;
  };
  for (const RoadEdge& edge : roads.edges) root[find(edge.from)] = find(edge.to);
  for (std::size_t i = 0; i < root.size(); ++i) EXPECT_EQ(find(i), find(0));
}

TEST_P(SyntheticTruth, EveryDeadEndIsTheMiddleOfItsTurningPlace) {
  const auto degree = degrees();
  const auto dead_ends = std::count(degree.begin(), degree.end(), 1);
  EXPECT_EQ(static_cast<std::size_t>(dead_ends), world.layout.network.dead_ends.size());
  EXPECT_GE(dead_ends, 2);
  for (const DeadEnd& end : world.layout.network.dead_ends) {
    const Vector2 middle = world.layout.network.centre(end);
    const Vector2 ahead = world.layout.network.heading(end), left(-ahead.y(), ahead.x());
    EXPECT_NEAR(free_way(middle, left), end.radius, 0.6);
    EXPECT_NEAR(free_way(middle, -left), end.radius, 0.6);
  }
}

TEST_P(SyntheticTruth, HasOneCycleForEachIslandOfObstacles) {
  // Islands: obstacle cells that the map's border cannot be reached from, by 8-neighbours.
  const GridFrame& frame = grid.frame;
  std::vector<std::uint8_t> seen(frame.size(), 0);
  std::size_t islands = 0;
  for (std::size_t start = 0; start < frame.size(); ++start) {
    if (grid.cells[start] == OccupancyGrid::kFree || seen[start]) continue;
    bool at_border = false;
    std::vector<std::size_t> open{start};
    seen[start] = 1;
    while (!open.empty()) {
      const std::size_t place = open.back();
      open.pop_back();
      const auto column = static_cast<std::int32_t>(place % static_cast<std::size_t>(frame.width));
      const auto row = static_cast<std::int32_t>(place / static_cast<std::size_t>(frame.width));
      for (std::int32_t k = 0; k < 9; ++k) {
        const Cell next{column + k % 3 - 1, row + k / 3 - 1};
        if (!frame.contains(next)) {
          at_border = true;
          continue;
        }
        const std::size_t there = frame.place(next);
        if (grid.cells[there] == OccupancyGrid::kFree || seen[there]) continue;
        seen[there] = 1;
        open.push_back(there);
      }
    }
    islands += at_border ? 0 : 1;
  }
  EXPECT_EQ(roads.edges.size() - roads.nodes.size() + 1, islands);
  EXPECT_GE(islands, 1u);
}

TEST_P(SyntheticTruth, TheTruckStaysOnTheRoadAndCanDriveItsBends) {
  const auto legs = covering_route(world.graph);
  std::vector<bool> driven(world.graph.edges.size());
  for (const Leg& leg : legs) driven[leg.edge] = true;
  EXPECT_TRUE(std::all_of(driven.begin(), driven.end(), [](bool edge) { return edge; }));

  const auto line = route_line(world.layout.network, world.graph, legs, world.layout.rules);
  EXPECT_GT(smallest_radius(line, false, 4), 10.3);
  for (std::size_t i = 4; i + 4 < line.size(); i += 3) {
    const Vector2 ahead = (line[i + 2] - line[i - 2]).normalized(), left(-ahead.y(), ahead.x());
    for (const double along : {-4.5, 0.0, 4.5}) {
      for (const double aside : {-2.0, 2.0})
        EXPECT_TRUE(is_free(line[i] + along * ahead + aside * left));
    }
  }
}

TEST_P(SyntheticTruth, RoadsKeepTheirGradeAndLieOnTheGround) {
  for (const RoadEdge& edge : roads.edges) {
    const auto line = roads.polyline(edge);
    for (std::size_t i = 0; i < line.size(); ++i) {
      EXPECT_NEAR(line[i].z, world.terrain.height_at(line[i].x, line[i].y), 0.35);
      if (i == 0) continue;
      const double step = std::hypot(line[i].x - line[i - 1].x, line[i].y - line[i - 1].y);
      EXPECT_LE(std::abs(line[i].z - line[i - 1].z), 1.06 * world.layout.rules.grade * step);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Mines, SyntheticTruth, ::testing::Values(0, 1, 2, 3));

}  // namespace
}  // namespace stope::source
