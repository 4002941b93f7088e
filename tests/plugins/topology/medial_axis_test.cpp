// The dividing lines of topology/skeleton against the definition of the medial axis, by looking at
// every obstacle cell, and against corners whose medial axis is known.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <set>
#include <utility>

#include "plugins/topology/trace_lines.hpp"
#include "tests/plugins/topology/graph_checks.hpp"
#include "tests/plugins/topology/test_grids.hpp"

namespace stope::topology {
namespace {

struct Lines {
  Lines(const OccupancyGrid& grid, std::int32_t gap,
        const std::function<SideRule(const Outlines&)>& rule)
      : space(make_free_space(grid, {})),
        edges(space.width(), space.height()),
        outlines(trace_outlines(space, edges, 0, gap)) {
    find_nearest_outline(space, outlines, edges);
    find_dividing_lines(space, outlines, rule(outlines), edges, never_stop, &replaced);
  }
  bool was_replaced(CellIndex cell) const {
    for (const ReplacedEdge& other : replaced)
      if (other.cell == cell) return true;
    return false;
  }
  FreeSpace space;
  EdgeGrid edges;
  Outlines outlines;
  std::vector<ReplacedEdge> replaced;
};

/// The obstacle cells nearest to each free cell of a small grid with its margin of one cell.
class NaiveFeatures {
 public:
  explicit NaiveFeatures(const OccupancyGrid& grid) : width_(grid.frame.width + 2) {
    int obstacles = 0, frees = 0;
    label_ = label_pieces(grid, obstacles, frees);
  }
  struct Feature {
    int column = 0, row = 0, obstacle = 0;
  };
  std::vector<Feature> nearest(int column, int row) const {
    std::vector<Feature> result;
    int least = std::numeric_limits<int>::max();
    for (std::size_t i = 0; i < label_.size(); ++i) {
      if (label_[i] < 0) continue;
      const int x = static_cast<int>(i) % width_ - 1, y = static_cast<int>(i) / width_ - 1;
      const int distance = (x - column) * (x - column) + (y - row) * (y - row);
      if (distance < least) result.clear();
      least = std::min(least, distance);
      if (distance == least) result.push_back({x, y, label_[i]});
    }
    return result;
  }

 private:
  int width_;
  std::vector<int> label_;
};

/// The steps of lines between sides that see places of two outlines or places `lambda` cells apart,
/// by the cell and whether its neighbour is the northern one.
std::set<std::pair<CellIndex, bool>> wide_steps(Lines& map, double lambda) {
  std::vector<CellIndex> corners;
  for (CellIndex cell = 0; cell < static_cast<CellIndex>(map.space.size()); ++cell)
    if (map.space[cell] & kCorner) corners.push_back(cell);
  Courses courses(false);
  LineTracer tracer(map.space, map.outlines, map.edges, courses, lambda);
  std::set<std::pair<CellIndex, bool>> wide;
  for (const TracedLine& line : trace_lines(tracer, corners)) {
    const auto outline = [&](int side) {
      return map.outlines
          .of_edge[static_cast<std::size_t>(line.sides[static_cast<std::size_t>(side)])];
    };
    auto narrow = line.narrow.begin();
    for (std::size_t i = 1; i < line.corners.size(); ++i) {
      const auto step = static_cast<std::int32_t>(i) - 1;
      while (narrow != line.narrow.end() && narrow->end <= step) ++narrow;
      const bool is_narrow = narrow != line.narrow.end() && narrow->begin <= step;
      if (is_narrow && outline(0) == outline(1)) continue;
      const CellIndex low = std::min(line.corners[i - 1], line.corners[i]);
      const CellIndex high = std::max(line.corners[i - 1], line.corners[i]);
      wide.emplace(high, high - low == 1);
    }
  }
  return wide;
}

// Between two neighbours that each see one obstacle cell alone there is no choice: a line of the
// lambda-medial axis runs if these two are that far apart or belong to different obstacles.
TEST(MedialAxis, ByLambdaIsWhatItsDefinitionSaysOfEveryPairOfCells) {
  constexpr double kLambda = 5.0;
  std::size_t lines = 0, pairs = 0;
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    const OccupancyGrid grid = random_grid(34, 28, seed % 2 ? 0.8 : 0.97, seed % 2 ? 4 : 2, seed);
    Lines map(grid, 3, SideRule::between_sides);
    const auto wide = wide_steps(map, kLambda);
    const NaiveFeatures naive(grid);
    for (std::int32_t row = 0; row < grid.frame.height; ++row) {
      for (std::int32_t column = 0; column < grid.frame.width; ++column) {
        for (const bool north : {false, true}) {
          const std::int32_t x = column + (north ? 0 : 1), y = row + (north ? 1 : 0);
          if (!grid.frame.contains({x, y})) continue;
          const CellIndex a = map.space.index(column, row), b = map.space.index(x, y);
          if ((map.space[a] & kObstacle) || (map.space[b] & kObstacle)) continue;
          if (map.was_replaced(a) || map.was_replaced(b)) continue;
          const auto seen_a = naive.nearest(column, row), seen_b = naive.nearest(x, y);
          if (seen_a.size() != 1 || seen_b.size() != 1) continue;
          const double apart =
              std::hypot(seen_a[0].column - seen_b[0].column, seen_a[0].row - seen_b[0].row);
          const bool wanted = seen_a[0].obstacle != seen_b[0].obstacle || apart >= kLambda;
          const bool found = wide.contains({a, north});
          ASSERT_EQ(found, wanted) << "seed " << seed << ", cell " << column << ", " << row;
          lines += found ? 1U : 0U;
          ++pairs;
        }
      }
    }
  }
  EXPECT_GT(lines, 2000U);
  EXPECT_GT(pairs, 10 * lines / 2);
}

/// How near to the corner of a wedge of free space its line begins, in metres, and where its places
/// are `lambda` cells apart. The wedge opens eastwards from (20, 60), turned, with walls 70 m long.
double start_of_line(double opening, double turn, double lambda,
                     const std::function<SideRule(const Outlines&)>& rule) {
  const double resolution = 0.5;
  const OccupancyGrid grid = grid_where(120, 120, resolution, [=](double x, double y) {
    const double u = x - 60, v = y - 60;
    const double along = std::cos(turn) * u + std::sin(turn) * v + 35;
    const double across = -std::sin(turn) * u + std::cos(turn) * v;
    return along > 0 && along < 70 && std::abs(across) < along * std::tan(opening / 2);
  });
  Lines map(grid, 3, rule);
  const auto wide = wide_steps(map, lambda);
  const double corner_x = 60 - 35 * std::cos(turn), corner_y = 60 - 35 * std::sin(turn);
  double nearest = 1e9;
  for (std::int32_t row = 0; row < grid.frame.height; ++row) {
    for (std::int32_t column = 0; column < grid.frame.width; ++column) {
      const CellIndex cell = map.space.index(column, row);
      if (!wide.contains({cell, false}) && !wide.contains({cell, true})) continue;
      const Vector2 place = grid.frame.centre({column, row});
      nearest = std::min(nearest, std::hypot(place.x() - corner_x, place.y() - corner_y));
    }
  }
  return nearest;
}

// A point of a wedge's bisector at a distance x from the corner sees its walls at x cos(o/2) from
// the corner, 2 x cos(o/2) sin(o/2) apart.
TEST(MedialAxis, ByLambdaBeginsWhereTheWallsOfACornerAreThatFarApart) {
  constexpr double kLambda = 12;  // metres
  for (const double opening : {0.6, 1.0, std::numbers::pi / 2}) {
    for (const double turn : {0.0, 0.3, 0.8}) {
      const double start = start_of_line(opening, turn, kLambda / 0.5, SideRule::between_sides);
      EXPECT_NEAR(start, kLambda / std::sin(opening), 1.5) << opening << ", turned by " << turn;
    }
  }
}

TEST(MedialAxis, ByChordResidualBeginsWhereTheWayRoundTheCornerIsThatMuchLonger) {
  constexpr double kResidual = 8;  // metres
  for (const double opening : {0.6, 1.0, std::numbers::pi / 2}) {
    for (const double turn : {0.0, 0.3, 0.8}) {
      OutlineWays ways;
      const double start = start_of_line(opening, turn, 0, [&](const Outlines& outlines) {
        ways = measure_ways(outlines);
        return SideRule::by_residual(outlines, ways, kResidual / 0.5);
      });
      const double half = opening / 2;
      // The way is smoothed over five cells, which cuts a sharp corner by some of them, and runs
      // through the centres of cells half a cell behind the walls.
      EXPECT_NEAR(start, kResidual / (2 * std::cos(half) * (1 - std::sin(half))), 3.5)
          << opening << ", turned by " << turn;
    }
  }
}

// A straight wall, however rough in single cells, sees itself from nowhere.
TEST(MedialAxis, ByChordResidualHasNoLineAtAWallOfAnyDirection) {
  for (const double turn : {0.0, 0.2, 0.463647609, 0.785398163}) {
    const OccupancyGrid grid = grid_where(80, 80, 0.5, [=](double x, double y) {
      return -std::sin(turn) * (x - 40) + std::cos(turn) * (y - 40) > 0;
    });
    OutlineWays ways;
    const Lines map(grid, 3, [&](const Outlines& outlines) {
      ways = measure_ways(outlines);
      return SideRule::by_residual(outlines, ways, 2);
    });
    for (std::int32_t row = 0; row < grid.frame.height; ++row) {
      for (std::int32_t column = 0; column < grid.frame.width; ++column) {
        // Far from the map's border, which is a wall of its own.
        const Vector2 place = grid.frame.centre({column, row});
        const double wall = -std::sin(turn) * (place.x() - 40) + std::cos(turn) * (place.y() - 40);
        const double border = std::min({place.x(), place.y(), 80 - place.x(), 80 - place.y()});
        if (wall <= 0 || wall > border - 2) continue;
        EXPECT_FALSE(map.space[map.space.index(column, row)] & (kDividedEast | kDividedNorth))
            << place.transpose() << ", turned by " << turn;
      }
    }
  }
}

}  // namespace
}  // namespace stope::topology
