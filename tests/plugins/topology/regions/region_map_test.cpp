#include <gtest/gtest.h>

#include <map>
#include <queue>
#include <set>

#include "tests/plugins/topology/regions/doors_by_flooding.hpp"
#include "tests/plugins/topology/regions/region_stages.hpp"

namespace stope::topology {
namespace {

class RegionMaps : public ::testing::TestWithParam<int> {
 protected:
  void make(std::uint64_t seed) {
    grid = random_grid(90, 70, 0.85, 6, seed);
    grid.frame.resolution = 0.1;
    grid.frame.origin = {12, -7, 0.3};
    StageHarness stage = for_rooms(region_stages()[static_cast<std::size_t>(GetParam())]);
    stage.set("allow_empty", true).set("min_clearance", 0.0).set("min_obstacle_area", 0.0);
    stage.set("min_region_area", 0.0);
    stage.input("grid", grid);
    map = stage.apply<RegionMap>(1);
    roads = stage.apply<RoadGraph>(0);
  }
  bool free(Cell cell) const {
    return grid.frame.contains(cell) && grid.cells[grid.frame.place(cell)] == OccupancyGrid::kFree;
  }
  std::int32_t label(Cell cell) const { return map.labels.cells[map.labels.frame.place(cell)]; }

  OccupancyGrid grid;
  RegionMap map;
  RoadGraph roads;
};

INSTANTIATE_TEST_SUITE_P(Members, RegionMaps, ::testing::Values(0, 1));

TEST_P(RegionMaps, LabelsAreThePlaceOfARegionThatIsOnePieceOfFreeSpace) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    make(seed);
    std::map<std::int32_t, std::vector<Cell>> cells;
    for (std::int32_t row = 0; row < 70; ++row)
      for (std::int32_t column = 0; column < 90; ++column) {
        EXPECT_EQ(label({column, row}) > 0, free({column, row}));  // all of free space is covered
        if (label({column, row}) > 0) cells[label({column, row})].push_back({column, row});
      }
    ASSERT_EQ(cells.size(), map.regions.size());
    for (std::size_t i = 0; i < map.regions.size(); ++i) {
      const auto& own = cells.at(static_cast<std::int32_t>(i) + 1);
      EXPECT_NEAR(map.regions[i].area, 0.01 * static_cast<double>(own.size()), 1e-9);
      if (i > 0) {
        EXPECT_LT(map.regions[i - 1].id, map.regions[i].id);
      }
      const auto centre = grid.frame.cell_at(map.regions[i].x, map.regions[i].y);
      ASSERT_TRUE(centre);
      EXPECT_EQ(label(*centre), static_cast<std::int32_t>(i) + 1);
      std::set<std::size_t> reached{grid.frame.place(own[0])};
      std::queue<Cell> open;
      open.push(own[0]);
      while (!open.empty()) {
        const Cell at = open.front();
        open.pop();
        for (int dy = -1; dy <= 1; ++dy)
          for (int dx = -1; dx <= 1; ++dx) {
            const Cell next{at.column + dx, at.row + dy};
            if (!grid.frame.contains(next) || label(next) != label(at)) continue;
            if (reached.insert(grid.frame.place(next)).second) open.push(next);
          }
      }
      EXPECT_EQ(reached.size(), own.size()) << "seed " << seed << ", region " << i;
    }
  }
}

TEST_P(RegionMaps, AdjacentAreThoseWhoseCellsTouch) {
  std::size_t several = 0;
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    make(seed);
    std::set<std::pair<std::uint32_t, std::uint32_t>> touching, listed;
    for (std::int32_t row = 0; row < 70; ++row)
      for (std::int32_t column = 0; column < 90; ++column)
        for (int dy = -1; dy <= 1; ++dy)
          for (int dx = -1; dx <= 1; ++dx) {
            const Cell a{column, row}, b{column + dx, row + dy};
            if (!free(a) || !free(b) || label(a) >= label(b)) continue;
            touching.insert({static_cast<std::uint32_t>(label(a)) - 1,
                             static_cast<std::uint32_t>(label(b)) - 1});
          }
    for (std::size_t i = 0; i + 1 < map.adjacency.size(); i += 2)
      listed.insert({map.adjacency[i], map.adjacency[i + 1]});
    EXPECT_EQ(listed, touching);
    EXPECT_EQ(2 * listed.size(), map.adjacency.size());
    // A road for each two regions or, with voronoi_regions, for each of their doors.
    const DoorsByFlooding doors(90, 70, [&](std::int32_t column, std::int32_t row) {
      return label({column, row});
    });
    std::map<std::pair<std::uint64_t, std::uint64_t>, std::int32_t> expected, led;
    for (const auto& [pair, count] : doors.count()) {
      const auto id = [&](std::int32_t region) {
        return map.regions[static_cast<std::size_t>(region) - 1].id;
      };
      expected[std::minmax({id(pair.first), id(pair.second)})] = GetParam() == 0 ? 1 : count;
      several += count > 1 ? 1U : 0U;
    }
    for (const RoadEdge& edge : roads.edges)
      ++led[std::minmax({roads.nodes[edge.from].id, roads.nodes[edge.to].id})];
    EXPECT_EQ(led, expected);
  }
  EXPECT_GT(several, 20U);
}

TEST_P(RegionMaps, RoadsStayInFreeSpaceAndTellTheirClearance) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    make(seed);
    const auto clearance = [&](double x, double y) {  // from an obstacle cell's centre
      const Vector2 at = grid.frame.to_grid(x, y);
      double least = 1e9;
      for (std::int32_t row = -1; row <= 70; ++row)
        for (std::int32_t column = -1; column <= 90; ++column)
          if (!free({column, row}))
            least = std::min(least, std::hypot(column + 0.5 - at.x(), row + 0.5 - at.y()));
      return 0.1 * std::max(0.0, least - 0.5);
    };
    for (const RoadEdge& edge : roads.edges) {
      const auto line = roads.polyline(edge);
      ASSERT_GE(line.size(), 2U);
      EXPECT_EQ(line.front().x, roads.nodes[edge.from].x);
      EXPECT_EQ(line.back().y, roads.nodes[edge.to].y);
      for (std::size_t i = 1; i < line.size(); ++i)
        for (int k = 0; k <= 60; ++k) {
          const auto cell =
              grid.frame.cell_at(line[i - 1].x + k / 60.0 * (line[i].x - line[i - 1].x),
                                 line[i - 1].y + k / 60.0 * (line[i].y - line[i - 1].y));
          // A line through the corner that two free cells share may graze the obstacles there.
          ASSERT_TRUE(cell);
          bool near_free = false;
          for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx)
              near_free = near_free || (std::abs(dx) + std::abs(dy) < 2 &&
                                        free({cell->column + dx, cell->row + dy}));
          EXPECT_TRUE(near_free);
        }
    }
    for (std::size_t i = 0; i < roads.vertices.size(); i += 17)
      EXPECT_NEAR(roads.vertices[i].clearance, clearance(roads.vertices[i].x, roads.vertices[i].y),
                  1e-6);
  }
}

TEST_P(RegionMaps, AreTheSameEveryTime) {
  make(3);
  const RegionMap first = map;
  const RoadGraph graph = roads;
  make(3);
  EXPECT_EQ(digest_of(first).low, digest_of(map).low);
  EXPECT_EQ(digest_of(graph).low, digest_of(roads).low);
}

}  // namespace
}  // namespace stope::topology
