#include <gtest/gtest.h>

#include <cmath>

#include "tests/plugins/stage_harness.hpp"

extern "C" const stope::StageEntry* stope_stage_Maximum();
extern "C" const stope::StageEntry* stope_stage_Bayes();

namespace stope::fusion {
namespace {

using stope::testing::StageHarness;
constexpr std::uint8_t kU = OccupancyGrid::kUnknown;

OccupancyGrid grid_of(std::int32_t width, std::int32_t height, double resolution, Pose2 origin,
                      std::vector<std::uint8_t> cells) {
  OccupancyGrid grid;
  grid.frame = {width, height, resolution, origin};
  grid.cells = std::move(cells);
  return grid;
}

OccupancyGrid random_grid(Random& random, std::int32_t width, std::int32_t height,
                          double resolution, Pose2 origin) {
  OccupancyGrid grid = grid_of(width, height, resolution, origin, {});
  for (std::size_t i = 0; i < grid.frame.size(); ++i)
    grid.cells.push_back(static_cast<std::uint8_t>(random.below(3) == 0 ? 255 : random.below(255)));
  return grid;
}

OccupancyGrid maximum(const OccupancyGrid& prior, const OccupancyGrid& live) {
  return StageHarness(stope_stage_Maximum())
      .input("prior", prior)
      .input("live", live)
      .apply<OccupancyGrid>();
}

OccupancyGrid bayes(const OccupancyGrid& prior, const OccupancyGrid& live, double live_weight = 1) {
  return StageHarness(stope_stage_Bayes())
      .input("prior", prior)
      .input("live", live)
      .set("live_weight", live_weight)
      .apply<OccupancyGrid>();
}

std::uint8_t value_at(const OccupancyGrid& grid, const Vector2& point) {
  const auto cell = grid.frame.cell_at(point.x(), point.y());
  return cell ? grid.cells[grid.frame.place(*cell)] : kU;
}

TEST(Maximum, TakesTheHigherAndLetsUnknownYield) {
  const auto prior = grid_of(3, 2, 1, {}, {0, 100, kU, 254, kU, 7});
  const auto live = grid_of(3, 2, 1, {}, {254, 50, 33, kU, kU, 8});
  EXPECT_EQ(maximum(prior, live).cells, (std::vector<std::uint8_t>{254, 100, 33, 254, kU, 8}));
}

TEST(Fusion, ASharedLatticeIsJoinedCellOnCellOverBothExtents) {
  Random random(1);
  for (const double yaw : {0.0, 0.7}) {
    for (int trial = 0; trial < 20; ++trial) {
      const auto prior = random_grid(random, 23, 17, 0.5, {4, -3, yaw});
      const Vector2 corner = prior.frame.to_map(static_cast<double>(random.below(60)) - 30,
                                                static_cast<double>(random.below(60)) - 30);
      const auto live = random_grid(random, 19, 29, 0.5, {corner.x(), corner.y(), yaw});
      const auto joined = maximum(prior, live);
      for (std::int32_t row = 0; row < joined.frame.height; ++row) {
        for (std::int32_t column = 0; column < joined.frame.width; ++column) {
          const Vector2 centre = joined.frame.centre({column, row});
          const std::uint8_t a = value_at(prior, centre), b = value_at(live, centre);
          const std::uint8_t expected = a == kU ? b : b == kU ? a : std::max(a, b);
          ASSERT_EQ(joined.cells[joined.frame.place({column, row})], expected);
        }
      }
      // Every cell of either has its place.
      for (const auto* grid : {&prior, &live}) {
        for (const Cell cell : {Cell{0, 0}, Cell{grid->frame.width - 1, grid->frame.height - 1}}) {
          const Vector2 centre = grid->frame.centre(cell);
          EXPECT_TRUE(joined.frame.cell_at(centre.x(), centre.y()));
        }
      }
    }
  }
}

TEST(Fusion, TheOrderOfUnknownGridsDoesNotMatterToMaximum) {
  Random random(2);
  const auto a = random_grid(random, 20, 20, 1, {0, 0, 0});
  const auto b = random_grid(random, 20, 20, 1, {0, 0, 0});
  EXPECT_EQ(maximum(a, b).cells, maximum(b, a).cells);
  EXPECT_EQ(maximum(a, a).cells, a.cells);
}

TEST(Fusion, AnotherLatticeIsLookedUpAtTheCentres) {
  Random random(3);
  const auto prior = grid_of(20, 20, 1, {}, std::vector<std::uint8_t>(400, kU));
  const auto live = random_grid(random, 12, 12, 1, {3.3, 4.4, 0.3});
  const auto joined = maximum(prior, live);
  for (std::int32_t row = 0; row < 20; ++row) {
    for (std::int32_t column = 0; column < 20; ++column) {
      const Vector2 centre = prior.frame.centre({column, row});
      EXPECT_EQ(value_at(joined, centre), value_at(live, centre));
    }
  }
}

TEST(Fusion, AFinerGridsThinObstacleIsNotLost) {
  const auto prior = grid_of(10, 10, 1, {}, std::vector<std::uint8_t>(100, kU));
  auto live = grid_of(100, 100, 0.1, {}, std::vector<std::uint8_t>(10000, 0));
  for (std::int32_t y = 0; y < 100; ++y) live.cells[live.frame.place({42, y})] = 254;
  const auto joined = maximum(prior, live);
  for (std::int32_t y = 0; y < 10; ++y) {
    EXPECT_EQ(joined.cells[joined.frame.place({4, y})], 254);
    EXPECT_EQ(joined.cells[joined.frame.place({5, y})], 0);
  }
}

TEST(Bayes, AddsUpLogOdds) {
  const auto probability = [](int cell) { return std::clamp(cell / 254.0, 0.02, 0.98); };
  auto prior = grid_of(255, 255, 1, {}, {}), live = prior;
  for (int a = 0; a < 255; ++a) {
    for (int b = 0; b < 255; ++b) {
      prior.cells.push_back(static_cast<std::uint8_t>(a));
      live.cells.push_back(static_cast<std::uint8_t>(b));
    }
  }
  const auto joined = bayes(prior, live);
  for (std::size_t i = 0; i < joined.cells.size(); ++i) {
    const double a = probability(prior.cells[i]), b = probability(live.cells[i]);
    const double expected = a * b / (a * b + (1 - a) * (1 - b));
    ASSERT_NEAR(joined.cells[i] / 254.0, expected, 0.5 / 254 + 1e-9);
  }
}

TEST(Bayes, UnknownIsNoEvidence) {
  const auto prior = grid_of(3, 1, 1, {}, {kU, 254, kU});
  const auto live = grid_of(3, 1, 1, {}, {200, kU, kU});
  const auto joined = bayes(prior, live);
  EXPECT_EQ(joined.cells[0], 200);
  EXPECT_EQ(joined.cells[1], 249);  // 0.98 of 254
  EXPECT_EQ(joined.cells[2], kU);
}

TEST(Bayes, AContradictionIsNotFreeUnlessTheLiveGridIsBelieved) {
  const auto prior = grid_of(1, 1, 1, {}, {254}), live = grid_of(1, 1, 1, {}, {0});
  EXPECT_EQ(bayes(prior, live).cells[0], 127);
  EXPECT_LT(bayes(prior, live, 3).cells[0], 20);
}

TEST(Fusion, MembersAreInterchangeable) {
  const StageHarness a(stope_stage_Maximum()), b(stope_stage_Bayes());
  ASSERT_EQ(a.info().inputs.size(), b.info().inputs.size());
  for (std::size_t i = 0; i < a.info().inputs.size(); ++i) {
    EXPECT_EQ(a.info().inputs[i].name, b.info().inputs[i].name);
    EXPECT_EQ(a.info().inputs[i].type, b.info().inputs[i].type);
  }
  EXPECT_EQ(a.info().outputs[0].name, b.info().outputs[0].name);
}

TEST(Fusion, TheChangedWindowIsGivenOnlyWhereItIsKnown) {
  auto prior = grid_of(10, 10, 1, {}, std::vector<std::uint8_t>(100, 0));
  auto live = grid_of(5, 5, 1, {4, 4, 0}, std::vector<std::uint8_t>(25, 0));
  live.changed = ChangedWindow{1, 2, 2, 2, 7};
  EXPECT_FALSE(maximum(prior, live).changed);  // any of the prior may have changed
  prior.changed = ChangedWindow{0, 0, 1, 1, 7};
  const auto joined = maximum(prior, live);
  ASSERT_TRUE(joined.changed);
  EXPECT_EQ(joined.changed->column, 0);
  EXPECT_EQ(joined.changed->width, 7);   // to column 4 + 1 + 2
  EXPECT_EQ(joined.changed->height, 8);  // to row 4 + 2 + 2
  live.changed->since = 6;
  EXPECT_FALSE(maximum(prior, live).changed);
}

TEST(Fusion, GridsFarApartOrEmptyAreRefused) {
  const auto here = grid_of(1, 1, 0.1, {}, {0}), there = grid_of(1, 1, 0.1, {1e7, 1e7, 0}, {0});
  EXPECT_NE(stope::testing::error_of([&] { maximum(here, there); }).find("in the same frame?"),
            std::string::npos);
  EXPECT_NE(stope::testing::error_of([&] { maximum(here, OccupancyGrid{}); }).find("no cells"),
            std::string::npos);
}

}  // namespace
}  // namespace stope::fusion
