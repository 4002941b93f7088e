#include "plugins/topology/dividing_lines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <queue>
#include <set>

#include "tests/plugins/topology/graph_checks.hpp"
#include "tests/plugins/topology/test_grids.hpp"

namespace stope::topology {
namespace {

/// Meyer's flooding of the distance to obstacles, cell by cell from a queue, written to be obvious.
/// A cell joins a front that reaches it from a 4-neighbour nearer to an obstacle: one of its
/// nearest obstacle's if there is one, else that of its nearest neighbour. Where the rule leaves a
/// choice, all choices are kept.
class NaiveFlood {
 public:
  explicit NaiveFlood(const OccupancyGrid& grid) : width_(grid.frame.width + 2) {
    int obstacles = 0, frees = 0;
    label_ = label_pieces(grid, obstacles, frees);
    const auto count = static_cast<int>(label_.size());
    distance_.assign(label_.size(), 0);
    basins_.resize(label_.size());
    std::priority_queue<std::pair<int, int>, std::vector<std::pair<int, int>>, std::greater<>> open;
    for (int cell = 0; cell < count; ++cell) {
      if (label_[at(cell)] >= 0) basins_[at(cell)] = {label_[at(cell)]};
      distance_[at(cell)] = nearest(cell).first;
      if (label_[at(cell)] < 0) open.emplace(distance_[at(cell)], cell);
    }
    for (; !open.empty(); open.pop()) flood(open.top().second);
  }
  const std::set<int>& basins(std::int32_t column, std::int32_t row) const {
    return basins_[at((row + 1) * width_ + column + 1)];
  }
  int label(std::int32_t column, std::int32_t row) const {
    return label_[at((row + 1) * width_ + column + 1)];
  }

 private:
  static std::size_t at(int cell) { return static_cast<std::size_t>(cell); }
  std::pair<int, std::set<int>> nearest(int cell) const {
    int least = 1 << 30;
    std::set<int> names;
    for (int other = 0; other < static_cast<int>(label_.size()); ++other) {
      if (label_[at(other)] < 0) continue;
      const int dx = other % width_ - cell % width_, dy = other / width_ - cell / width_;
      const int distance = dx * dx + dy * dy;
      if (distance < least) names.clear();
      least = std::min(least, distance);
      if (distance == least) names.insert(label_[at(other)]);
    }
    return {least, names};
  }
  void flood(int cell) {
    const std::set<int> own = nearest(cell).second;
    std::set<int> reaching_own, sure, of_nearest;
    int least = distance_[at(cell)];
    for (const int next : {cell - 1, cell + 1, cell - width_, cell + width_}) {
      const int there = distance_[at(next)];
      if (there >= distance_[at(cell)]) continue;
      for (const int basin : basins_[at(next)])
        if (own.contains(basin)) reaching_own.insert(basin);
      if (basins_[at(next)].size() == 1) sure.insert(*basins_[at(next)].begin());
      if (there < least) of_nearest.clear();
      least = std::min(least, there);
      if (there == least) of_nearest.insert(basins_[at(next)].begin(), basins_[at(next)].end());
    }
    // Any of several nearest obstacles may be the one taken, also one whose front stays away.
    basins_[at(cell)] = reaching_own;
    if (!std::includes(sure.begin(), sure.end(), own.begin(), own.end()))
      basins_[at(cell)].insert(of_nearest.begin(), of_nearest.end());
  }

  int width_;
  std::vector<int> label_, distance_;
  std::vector<std::set<int>> basins_;
};

struct Divided {
  explicit Divided(const OccupancyGrid& grid)
      : space(make_free_space(grid, {})),
        edges(space.width(), space.height()),
        outlines(trace_outlines(space, edges, 0, 4)) {
    find_nearest_outline(space, outlines, edges);
    find_dividing_lines(space, outlines, SideRule::between_outlines(outlines), edges);
  }
  FreeSpace space;
  EdgeGrid edges;
  Outlines outlines;
};

std::vector<OccupancyGrid> samples() {
  std::vector<OccupancyGrid> grids;
  for (std::uint64_t seed = 0; seed < 25; ++seed) {
    grids.push_back(random_grid(17, 14, 0.6, 1, seed));
    grids.push_back(random_grid(19, 21, 0.85, 1, seed));
    grids.push_back(random_grid(24, 22, 0.95, 1, seed));
    grids.push_back(random_grid(26, 24, 0.7, 3, seed));
  }
  return grids;
}

TEST(DividingLines, BasinsAreThoseOfFloodingByDistance) {
  for (const OccupancyGrid& grid : samples()) {
    const Divided map(grid);
    const NaiveFlood flood(grid);
    for (std::int32_t row = 0; row < grid.frame.height; ++row) {
      for (std::int32_t column = 0; column < grid.frame.width; ++column) {
        const CellIndex cell = map.space.index(column, row);
        if (map.space[cell] & kObstacle) continue;
        const auto place = map.outlines.place[static_cast<std::size_t>(map.edges[cell])];
        ASSERT_TRUE(flood.basins(column, row).contains(flood.label(place.column, place.row)))
            << "cell " << column << ", " << row;
      }
    }
  }
}

/// Pieces of the plane, obstacles included, when it is cut along the marked lines.
int pieces_cut(const FreeSpace& space) {
  const CellIndex stride = space.stride();
  std::vector<bool> seen(space.size(), false);
  int pieces = 0;
  for (CellIndex start = 0; start < static_cast<CellIndex>(space.size()); ++start) {
    if (seen[static_cast<std::size_t>(start)]) continue;
    ++pieces;
    std::vector<CellIndex> open{start};
    seen[static_cast<std::size_t>(start)] = true;
    while (!open.empty()) {
      const CellIndex cell = open.back();
      open.pop_back();
      const auto reach = [&](CellIndex next, bool inside, bool divided) {
        if (!inside || divided || seen[static_cast<std::size_t>(next)]) return;
        seen[static_cast<std::size_t>(next)] = true;
        open.push_back(next);
      };
      const std::int32_t column = space.column(cell), row = space.row(cell);
      reach(cell + 1, column < space.width(), space[cell] & kDividedEast);
      reach(cell + stride, row < space.height(), space[cell] & kDividedNorth);
      if (column >= 0) reach(cell - 1, true, space[cell - 1] & kDividedEast);
      if (row >= 0) reach(cell - stride, true, space[cell - stride] & kDividedNorth);
    }
  }
  return pieces;
}

TEST(DividingLines, EncloseEachObstacleAndNothingElse) {
  for (const OccupancyGrid& grid : samples()) {
    int obstacles = 0, frees = 0;
    label_pieces(grid, obstacles, frees);
    for (const bool sides : {false, true}) {
      FreeSpace space = make_free_space(grid, {});
      EdgeGrid edges(space.width(), space.height());
      const Outlines outlines = trace_outlines(space, edges, 0, 3);
      find_nearest_outline(space, outlines, edges);
      find_dividing_lines(
          space, outlines,
          sides ? SideRule::between_sides(outlines) : SideRule::between_outlines(outlines), edges);
      EXPECT_EQ(pieces_cut(space), obstacles);
    }
  }
}

}  // namespace
}  // namespace stope::topology
