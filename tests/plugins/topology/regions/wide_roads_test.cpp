#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <set>

#include "plugins/topology/describe_extraction.hpp"
#include "tests/plugins/topology/regions/region_stages.hpp"

namespace stope::topology {
namespace {

/// A grid's free cells by brute force: how far each is from every obstacle, and which of those that
/// are far enough hang together.
class WideCells {
 public:
  WideCells(const OccupancyGrid& grid, double min_clearance)
      : frame_(grid.frame), grid_(grid), piece_(frame_.size()), wide_(frame_.size(), false) {
    for (std::int32_t row = -1; row <= frame_.height; ++row)
      for (std::int32_t column = -1; column <= frame_.width; ++column)
        if (!free({column, row})) obstacles_.push_back({column, row});
    for_each([&](Cell cell) {
      wide_[frame_.place(cell)] =
          free(cell) && clearance(cell.column + 0.5, cell.row + 0.5) >= min_clearance - 1e-9;
    });
    for_each([&](Cell cell) {
      for (int dy = 0; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx)
          if (const Cell other{cell.column + dx, cell.row + dy}; has(cell) && has(other))
            piece_.join(static_cast<std::int32_t>(frame_.place(cell)),
                        static_cast<std::int32_t>(frame_.place(other)));
    });
  }

  bool free(Cell cell) const {
    return frame_.contains(cell) && grid_.cells[frame_.place(cell)] == OccupancyGrid::kFree;
  }
  bool has(Cell cell) const { return frame_.contains(cell) && wide_[frame_.place(cell)]; }
  std::int32_t piece(Cell cell) {
    return piece_.find(static_cast<std::int32_t>(frame_.place(cell)));
  }
  /// From the edge of the nearest obstacle, in metres; the place in cells.
  double clearance(double x, double y) const {
    double least = 1e9;
    for (const Cell& cell : obstacles_)
      least = std::min(least, std::hypot(cell.column + 0.5 - x, cell.row + 0.5 - y));
    return (least - 0.5) * frame_.resolution;
  }
  template <class Visit>
  void for_each(Visit visit) const {
    for (std::int32_t row = 0; row < frame_.height; ++row)
      for (std::int32_t column = 0; column < frame_.width; ++column) visit(Cell{column, row});
  }

 private:
  GridFrame frame_;
  const OccupancyGrid& grid_;
  DisjointSets piece_;
  std::vector<bool> wide_;
  std::vector<Cell> obstacles_;
};

std::vector<std::int32_t> networks(const RoadGraph& roads) {
  DisjointSets sets(roads.nodes.size());
  for (const RoadEdge& edge : roads.edges)
    sets.join(static_cast<std::int32_t>(edge.from), static_cast<std::int32_t>(edge.to));
  std::vector<std::int32_t> network(roads.nodes.size());
  for (std::size_t i = 0; i < network.size(); ++i)
    network[i] = sets.find(static_cast<std::int32_t>(i));
  return network;
}

class WideRoads : public ::testing::TestWithParam<int> {
 protected:
  void make(const OccupancyGrid& grid, double min_clearance, double min_region_area) {
    StageHarness stage = for_rooms(region_stages()[static_cast<std::size_t>(GetParam())]);
    stage.set("allow_empty", true).set("min_clearance", min_clearance);
    stage.set("min_obstacle_area", 0.0).set("min_region_area", min_region_area);
    stage.input("grid", grid);
    map = stage.apply<RegionMap>(1);
    roads = stage.apply<RoadGraph>(0);
  }
  static bool is_growing() { return GetParam() == 0; }
  RegionMap map;
  RoadGraph roads;
};

INSTANTIATE_TEST_SUITE_P(Members, WideRoads, ::testing::Values(0, 1));

/// Blocks, and heaps between them: ways of all widths, rooms with several ways out.
OccupancyGrid blocks_and_heaps(std::uint64_t seed) {
  OccupancyGrid grid = random_grid(90, 70, 0.86, 7, seed);
  const OccupancyGrid heaps = random_grid(90, 70, 0.985, 2, seed + 1000);
  for (std::size_t i = 0; i < grid.cells.size(); ++i)
    if (heaps.cells[i] != OccupancyGrid::kFree) grid.cells[i] = OccupancyGrid::kOccupied;
  grid.frame.resolution = 0.1;
  return grid;
}

TEST_P(WideRoads, LeadWhereverThereIsAWayAsWideAndNowhereElse) {
  std::size_t dropped = 0, kept = 0;
  for (std::uint64_t seed = 0; seed < 24; ++seed) {
    const OccupancyGrid grid = blocks_and_heaps(seed);
    const double min_clearance = 0.05 + 0.1 * static_cast<double>(seed % 4);
    make(grid, min_clearance, seed % 3 == 0 ? 0.0 : 1.5);
    WideCells wide(grid, min_clearance);
    const auto network = networks(roads);
    // Wherever wide cells of two regions touch, roads lead from one to the other.
    std::set<std::pair<std::int32_t, std::int32_t>> open, touching;
    const auto label = [&](Cell cell) { return map.labels.cells[grid.frame.place(cell)]; };
    wide.for_each([&](Cell cell) {
      for (int dy = 0; dy <= 1; ++dy)
        for (int dx = -1; dx <= 1; ++dx) {
          const Cell other{cell.column + dx, cell.row + dy};
          if (!wide.free(cell) || !wide.free(other) || label(cell) == label(other)) continue;
          if (label(cell) == 0 || label(other) == 0) continue;  // specks
          touching.insert(std::minmax({label(cell), label(other)}));
          if (wide.has(cell) && wide.has(other))
            open.insert(std::minmax({label(cell), label(other)}));
        }
    });
    std::vector<std::int32_t> of_label;
    for (const Region& region : map.regions)
      for (std::size_t i = 0; i < roads.nodes.size(); ++i)
        if (roads.nodes[i].id == region.id) of_label.push_back(network[i]);
    ASSERT_EQ(of_label.size(), map.regions.size());
    for (const auto& [a, b] : open) {
      // What grows may hold together by a place too narrow for a way, and then loses some.
      if (is_growing()) break;
      EXPECT_EQ(of_label[static_cast<std::size_t>(a) - 1],
                of_label[static_cast<std::size_t>(b) - 1])
          << "seed " << seed << ", regions " << a << " and " << b;
    }
    // Nodes are in one network exactly if wide cells join them.
    std::map<std::int32_t, std::int32_t> piece_of;
    for (std::size_t i = 0; i < roads.nodes.size(); ++i) {
      const auto cell = grid.frame.cell_at(roads.nodes[i].x, roads.nodes[i].y);
      ASSERT_TRUE(cell);
      if (!wide.has(*cell)) {
        EXPECT_EQ(std::count(network.begin(), network.end(), network[i]), 1);
        continue;
      }
      const auto [known, is_new] = piece_of.emplace(network[i], wide.piece(*cell));
      EXPECT_EQ(known->second, wide.piece(*cell)) << "seed " << seed;
    }
    for (const RoadEdge& edge : roads.edges) {
      const auto line = roads.polyline(edge);
      for (std::size_t i = 1; i < line.size(); ++i)
        for (int k = 0; k <= 8; ++k) {
          const Vector2 at =
              grid.frame.to_grid(line[i - 1].x + k / 8.0 * (line[i].x - line[i - 1].x),
                                 line[i - 1].y + k / 8.0 * (line[i].y - line[i - 1].y));
          // Half way between two diagonal neighbours that are d cells from an obstacle the distance
          // is the root of d^2 - 1/2 at least.
          const double distance = min_clearance / 0.1 + 0.5;
          const double between = std::sqrt(distance * distance - 0.5) - 0.5;
          EXPECT_GE(wide.clearance(at.x(), at.y()), 0.1 * between - 1e-6) << "seed " << seed;
        }
      EXPECT_GE(edge.min_clearance, min_clearance - 1e-6);
    }
    kept += roads.edges.size();
    dropped += touching.size() - open.size();
  }
  EXPECT_GT(kept, 100U);
  EXPECT_GT(dropped, 20U);
}

/// A yard of 60 x 60 m, and a road of 12 m that leads up from it, round a quarter of a circle of
/// 40 m and on to a second yard.
constexpr double kHalfWidth = 6, kTurn = 40;

Point middle_of_road(double x, double y) {
  if (y < 110) return {90, y};
  if (x > 90 + kTurn) return {x, 110 + kTurn};
  const double dx = x - 90 - kTurn, dy = y - 110, radius = std::hypot(dx, dy);
  return {90 + kTurn + dx / radius * kTurn, 110 + dy / radius * kTurn};
}

OccupancyGrid yards_with_a_road() {
  return grid_where(280, 240, 1, [](double x, double y) {
    if (x > 10 && x < 96 && y > 10 && y < 70) return true;
    if (x > 200 && x < 270 && y > 90 && y < 230) return true;
    if (x < 80 || y < 60 || x > 210) return false;
    const Point middle = middle_of_road(x, y);
    return std::hypot(x - middle.x, y - middle.y) < kHalfWidth;
  });
}

TEST_P(WideRoads, KeepToTheMiddleHoweverWideTheYardsAre) {
  const OccupancyGrid grid = yards_with_a_road();
  StageHarness stage(region_stages()[static_cast<std::size_t>(GetParam())]);
  stage.input("grid", grid);
  const auto graph = stage.apply<RoadGraph>(0);
  EXPECT_EQ(count_pieces(graph), 1U);
  std::size_t looked_at = 0;
  for (const RoadEdge& edge : graph.edges) {
    const auto line = graph.polyline(edge);
    for (std::size_t i = 1; i < line.size(); ++i)
      for (int k = 0; k <= 10; ++k) {
        const double x = line[i - 1].x + k / 10.0 * (line[i].x - line[i - 1].x);
        const double y = line[i - 1].y + k / 10.0 * (line[i].y - line[i - 1].y);
        // Away from its mouths, where there is more room on one side. A third of its half width.
        if (y < 85 || x > 185) continue;
        const Point middle = middle_of_road(x, y);
        EXPECT_LT(std::hypot(x - middle.x, y - middle.y), kHalfWidth / 3) << x << ", " << y;
        ++looked_at;
      }
  }
  EXPECT_GT(looked_at, 20U);
}

}  // namespace
}  // namespace stope::topology
