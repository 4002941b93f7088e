#include "plugins/metric/geodesics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <queue>

#include "tests/plugins/metric/drawn_grid.hpp"
#include "tests/plugins/metric/drawn_roads.hpp"
#include "tests/plugins/stage_harness.hpp"

extern "C" const stope::StageEntry* stope_stage_Detour();

namespace stope::metric {
namespace {

// Whether a straight line stays in closed free cells: between its crossings with the lattice, the
// middle of each part must lie in one, or between two of which one is free.
bool stays_free(const FreeCells& cells, const Vector2& a, const Vector2& b) {
  std::vector<double> cuts{0, 1};
  for (int axis = 0; axis < 2; ++axis) {
    if (a[axis] == b[axis]) continue;
    for (double line = std::ceil(std::min(a[axis], b[axis])); line <= std::max(a[axis], b[axis]);
         ++line)
      cuts.push_back((line - a[axis]) / (b[axis] - a[axis]));
  }
  std::sort(cuts.begin(), cuts.end());
  for (std::size_t i = 1; i < cuts.size(); ++i) {
    if (cuts[i] - cuts[i - 1] < 1e-9) continue;
    const Vector2 middle = a + 0.5 * (cuts[i] + cuts[i - 1]) * (b - a);
    bool free = false;
    for (const double dx : {-1e-6, 1e-6})
      for (const double dy : {-1e-6, 1e-6})
        free = free || cells.at(static_cast<std::int32_t>(std::floor(middle.x() + dx)),
                                static_cast<std::int32_t>(std::floor(middle.y() + dy)));
    if (!free) return false;
  }
  return true;
}

// Dijkstra over start, goal and all points of the lattice, each seeing each.
double by_visibility(const FreeCells& cells, const Vector2& from, const Vector2& to) {
  std::vector<Vector2> points{from, to};
  for (int y = 0; y <= cells.frame.height; ++y)
    for (int x = 0; x <= cells.frame.width; ++x) points.emplace_back(x, y);
  std::vector<double> travelled(points.size(), std::numeric_limits<double>::infinity());
  std::vector<bool> done(points.size());
  travelled[0] = 0;
  for (;;) {
    std::size_t here = points.size();
    for (std::size_t i = 0; i < points.size(); ++i)
      if (!done[i] && std::isfinite(travelled[i]) &&
          (here == points.size() || travelled[i] < travelled[here]))
        here = i;
    if (here == points.size() || here == 1) return travelled[1];
    done[here] = true;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double length = travelled[here] + (points[i] - points[here]).norm();
      if (length < travelled[i] && stays_free(cells, points[here], points[i]))
        travelled[i] = length;
    }
  }
}

TEST(Geodesics, AreThoseOfAVisibilityGraphOfAllPoints) {
  Random random(11);
  for (int round = 0; round < 60; ++round) {
    const OccupancyGrid grid =
        random_grid(random, 4 + static_cast<int>(random.below(6)),
                    4 + static_cast<int>(random.below(6)), random.uniform(0.1, 0.5));
    if (std::find(grid.cells.begin(), grid.cells.end(), 0) == grid.cells.end()) continue;
    const FreeCells cells = free_cells(grid, {});
    Geodesics geodesics(cells);
    std::vector<Vector2> places;
    while (places.size() < 6) {
      // Eighths of a cell: some lie on the lattice, some on its points.
      const Vector2 place(static_cast<double>(random.below(8 * 9)) / 8,
                          static_cast<double>(random.below(8 * 9)) / 8);
      bool free = false;
      for (const double dx : {-1e-6, 1e-6})
        for (const double dy : {-1e-6, 1e-6})
          free = free || cells.at(static_cast<std::int32_t>(std::floor(place.x() + dx)),
                                  static_cast<std::int32_t>(std::floor(place.y() + dy)));
      EXPECT_EQ(geodesics.between(place, place).has_value(), free);
      if (free) places.push_back(place);
    }
    for (const Vector2& a : places) {
      for (const Vector2& b : places) {
        const double expected = by_visibility(cells, a, b);
        const auto found = geodesics.between(a, b);
        ASSERT_TRUE(found);
        if (std::isinf(expected)) {
          EXPECT_TRUE(std::isinf(*found));
        } else {
          EXPECT_NEAR(*found, expected, 1e-9) << a.transpose() << " to " << b.transpose();
        }
      }
    }
  }
}

TEST(Geodesics, RoundASquareByHand) {
  OccupancyGrid grid = walled(22, 22);
  for (int row = 8; row < 14; ++row)
    for (int column = 8; column < 14; ++column)
      grid.cells[grid.frame.place({column, row})] = OccupancyGrid::kOccupied;
  const FreeCells cells = free_cells(grid, {});
  Geodesics geodesics(cells);
  // From 4 left of the middle's height to 4 right: two hypotenuses and the square's side.
  EXPECT_NEAR(*geodesics.between({4, 11}, {18, 11}), 6 + 2 * std::hypot(4, 3), 1e-12);
  EXPECT_NEAR(*geodesics.between({4, 4}, {18, 4}), 14, 1e-12);
  EXPECT_FALSE(geodesics.between({10, 10}, {4, 4}));
  EXPECT_FALSE(geodesics.between({-1, 4}, {4, 4}));
}

TEST(Geodesics, RoundADiscComeNearTheTangents) {
  // A disc of 20 m at 0.1 m: two tangents and an arc. The drawn disc is wrong by up to a cell.
  OccupancyGrid grid;
  grid.frame = {1000, 1000, 0.1, {-50, -50, 0}};
  for (int row = 0; row < 1000; ++row)
    for (int column = 0; column < 1000; ++column)
      grid.cells.push_back(grid.frame.centre({column, row}).norm() < 20 ? OccupancyGrid::kOccupied
                                                                        : OccupancyGrid::kFree);
  const FreeCells cells = free_cells(grid, {});
  Geodesics geodesics(cells);
  const double tangent = std::sqrt(40.0 * 40 - 20 * 20);
  const double arc = 20 * (std::numbers::pi - 2 * std::acos(20.0 / 40));
  EXPECT_NEAR(*geodesics.between({-40, 0}, {40, 0}), 2 * tangent + arc, 0.2);
}

TEST(Detour, ByHandInARingRoundASquare) {
  // A ring of 14 m sides in free space between walls and a square of 10 m: between opposite corners
  // of the ring the graph needs 28 m.
  OccupancyGrid grid = walled(22, 22);
  for (int row = 6; row < 16; ++row)
    for (int column = 6; column < 16; ++column)
      grid.cells[grid.frame.place({column, row})] = OccupancyGrid::kOccupied;
  const RoadGraph ring = draw_roads({{{4, 4}, {18, 4}, {18, 18}, {4, 18}, {4, 4}}});
  stope::testing::StageHarness stage(stope_stage_Detour());
  stage.input("roads", ring).input("grid", grid).set("min_distance", 5.0);
  const Measures measures = stage.apply<Measures>();
  EXPECT_GE(value_of(measures, "detour_p50"), 1);
  // The longest is between two places at equal way from a corner: at most 2 (a + b) / hypot(a, b).
  EXPECT_LE(value_of(measures, "detour_max"), std::sqrt(2.0) + 1e-3);
  EXPECT_GT(value_of(measures, "detour_max"), 1.15);
  EXPECT_EQ(value_of(measures, "detour_unreachable"), 0);
  stage.set("between", std::string("free"));
  EXPECT_GE(value_of(stage.apply<Measures>(), "detour_p50"), 1);
}

TEST(Detour, PairsThatTheGraphDoesNotJoinAreAShareOfTheirOwn) {
  stope::testing::StageHarness stage(stope_stage_Detour());
  stage.input("grid", walled(62, 62)).set("pairs", std::int64_t{2000});
  stage.input("roads", draw_roads({{{5, 5}, {55, 5}}, {{5, 55}, {55, 55}}}));
  const Measures measures = stage.apply<Measures>();
  EXPECT_NEAR(value_of(measures, "detour_max"), 1, 1e-3);
  EXPECT_GT(value_of(measures, "detour_unreachable"), 0.5);
  stage.input("roads", RoadGraph{});
  EXPECT_EQ(value_of(stage.apply<Measures>(), "detour_unreachable"), 1);
  EXPECT_TRUE(std::isinf(value_of(stage.apply<Measures>(), "detour_p95")));
}

TEST(Detour, AGraphThatCrossesObstaclesIsWarnedOf) {
  // A wall across the map but for a gap at its end; the graph goes straight through the wall.
  OccupancyGrid grid = walled(62, 62);
  for (int row = 0; row < 50; ++row)
    grid.cells[grid.frame.place({31, row})] = OccupancyGrid::kOccupied;
  stope::testing::StageHarness stage(stope_stage_Detour());
  stage.input("grid", grid).input("roads", draw_roads({{{5, 5}, {55, 5}}}));
  EXPECT_LT(value_of(stage.apply<Measures>(), "detour_p50"), 1);
  std::string all;
  for (const std::string& sentence : stage.context().sentences) all += sentence + "\n";
  EXPECT_NE(all.find("are shorter than the shortest way"), std::string::npos) << all;
}

TEST(Detour, TooFewPairsAreWarnedOf) {
  // All but a tenth of the road lies in the wall.
  OccupancyGrid grid = walled(62, 62);
  for (int row = 0; row < 62; ++row)
    for (int column = 8; column < 62; ++column)
      grid.cells[grid.frame.place({column, row})] = OccupancyGrid::kOccupied;
  stope::testing::StageHarness stage(stope_stage_Detour());
  stage.input("grid", grid)
      .input("roads", draw_roads({{{2, 5}, {60, 5}}}))
      .set("min_distance", 1.0);
  stage.apply<Measures>();
  std::string all;
  for (const std::string& sentence : stage.context().sentences) all += sentence + "\n";
  EXPECT_NE(all.find("of 200 pairs could be judged"), std::string::npos) << all;
}

TEST(Detour, GeodesicsThatKeepAwayAreLonger) {
  // A corridor of 6 m round a square. Ways that stay 2.5 m away turn on arcs, not at its corners.
  OccupancyGrid grid = walled(220, 220, 0.1);
  for (int row = 61; row < 159; ++row)
    for (int column = 61; column < 159; ++column)
      grid.cells[grid.frame.place({column, row})] = OccupancyGrid::kOccupied;
  stope::testing::StageHarness stage(stope_stage_Detour());
  stage.input("grid", grid).set("min_distance", 5.0);
  stage.input("roads",
              draw_roads({{{3.1, 3.1}, {18.9, 3.1}, {18.9, 18.9}, {3.1, 18.9}, {3.1, 3.1}}}));
  const double grazing = value_of(stage.apply<Measures>(), "detour_p95");
  stage.set("min_clearance", 2.5);
  EXPECT_LT(value_of(stage.apply<Measures>(), "detour_p95"), grazing - 0.05);
  stage.set("min_clearance", 3.5);  // nothing is that far from all walls
  EXPECT_EQ(value_of(stage.apply<Measures>(), "detour_unreachable"), 1);
}

TEST(Detour, OfTheTruthAndBesidesItAreToldApart) {
  // True roads round a corner, and a graph that zigzags along them at 45 degrees.
  const RoadGraph truth = draw_roads({{{5, 5}, {55, 5}, {55, 55}}});
  std::vector<Vector2> zigzag;
  for (int i = 0; i <= 50; ++i) zigzag.emplace_back(5 + i, 5 + i % 2);
  for (int i = 1; i <= 50; ++i) zigzag.emplace_back(55 - i % 2, 5 + i);
  stope::testing::StageHarness stage(stope_stage_Detour());
  stage.input("grid", walled(62, 62)).input("truth", truth).input("roads", draw_roads({zigzag}));
  const Measures measures = stage.apply<Measures>();
  EXPECT_NEAR(value_of(measures, "route_to_true_p50"), std::sqrt(2.0), 0.03);
  EXPECT_LE(value_of(measures, "true_detour_p95"), std::sqrt(2.0) + 0.05);
  EXPECT_NEAR(value_of(measures, "detour_p95"),
              std::sqrt(2.0) * value_of(measures, "true_detour_p95"), 0.05);
  stage.input("roads", truth);
  const Measures own = stage.apply<Measures>();
  EXPECT_NEAR(value_of(own, "route_to_true_max"), 1, 1e-9);
  EXPECT_NEAR(value_of(own, "true_detour_p95"), value_of(own, "detour_p95"), 1e-9);
}

TEST(Detour, TheSameSeedDrawsTheSamePairs) {
  stope::testing::StageHarness stage(stope_stage_Detour());
  Random random(1);
  stage.input("grid", walled(102, 102)).input("roads", random_roads(random, 8, 10, 100));
  const auto first = stage.apply<Measures>().values;
  EXPECT_EQ(stage.apply<Measures>().values, first);
  stage.context().reseed(77);
  EXPECT_NE(stage.apply<Measures>().values, first);
}

}  // namespace
}  // namespace stope::metric
