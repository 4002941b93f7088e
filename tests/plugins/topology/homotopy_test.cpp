#include <gtest/gtest.h>

#include "plugins/topology/extract_roads.hpp"
#include "tests/plugins/topology/everything.hpp"
#include "tests/plugins/topology/graph_checks.hpp"
#include "tests/plugins/topology/test_grids.hpp"

namespace stope::topology {
namespace {

class Homotopy : public testing::TestWithParam<std::tuple<double, int, double>> {};

TEST_P(Homotopy, VoronoiHasAPieceForEachPieceAndACycleForEachHole) {
  const auto [free, block, min_branch] = GetParam();
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const OccupancyGrid grid = random_grid(90, 70, free, block, seed);
    const RoadGraph roads = voronoi_roads(grid, everything(), {min_branch, 0.75});
    EXPECT_EQ(betti_of(roads).pieces, betti_of(grid).pieces) << "seed " << seed;
    EXPECT_EQ(betti_of(roads).cycles, betti_of(grid).cycles) << "seed " << seed;
  }
}

TEST_P(Homotopy, SkeletonHasAPieceForEachPieceAndACycleForEachHole) {
  const auto [free, block, min_branch] = GetParam();
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const OccupancyGrid grid = random_grid(90, 70, free, block, seed);
    for (const auto pruning :
         {SkeletonParams::Pruning::kChordResidual, SkeletonParams::Pruning::kLambda}) {
      for (const double least : {0.0, 8.0}) {
        const RoadGraph roads =
            skeleton_roads(grid, everything(), {min_branch, 0.75}, {pruning, least, least});
        EXPECT_EQ(betti_of(roads), betti_of(grid)) << "seed " << seed << " least " << least;
      }
    }
  }
}

TEST_P(Homotopy, WatershedOfPartsHasAPieceForEachPieceAndACycleForEachHole) {
  const auto [free, block, min_branch] = GetParam();
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const OccupancyGrid grid = random_grid(90, 70, free, block, seed);
    for (const double length : {4.0, 40.0}) {
      const RoadGraph roads =
          watershed_part_roads(grid, everything(), {min_branch, 0.75}, {1.0, length});
      EXPECT_EQ(betti_of(roads), betti_of(grid)) << "seed " << seed << " length " << length;
    }
  }
}

TEST_P(Homotopy, WatershedHasACycleForEachHole) {
  const auto [free, block, min_branch] = GetParam();
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    const OccupancyGrid grid = random_grid(90, 70, free, block, seed);
    const RoadGraph roads = watershed_roads(grid, everything());
    EXPECT_EQ(betti_of(roads).cycles, betti_of(grid).cycles) << "seed " << seed;
    EXPECT_TRUE(nodes_of_degree(roads, 1).empty()) << "a watershed has no end";
  }
}

INSTANTIATE_TEST_SUITE_P(RandomGrids, Homotopy,
                         testing::Combine(testing::Values(0.3, 0.6, 0.9, 0.98),
                                          testing::Values(1, 4, 9),
                                          testing::Values(0.0, 5.0, 20.0)));

}  // namespace
}  // namespace stope::topology
