#include "framework/report/graph/layered_layout.hpp"

#include <gtest/gtest.h>

#include "stope/random.hpp"

namespace stope::report {
namespace {

LayoutProblem random_problem(std::uint64_t seed, std::size_t boxes) {
  Random random(seed);
  LayoutProblem problem;
  for (std::size_t i = 0; i < boxes; ++i) problem.boxes.push_back({random.uniform(40, 120), 0});
  for (std::size_t to = 1; to < boxes; ++to) {
    for (std::uint64_t k = random.below(3); k > 0; --k)
      problem.wires.push_back({random.below(to), to, 20, 20});
  }
  return problem;
}

TEST(LayeredLayout, PutsReadersToTheRightAndNothingOnTopOfAnything) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const LayoutProblem problem = random_problem(seed, 5 + seed);
    const Layout layout = lay_out(problem);
    for (std::size_t w = 0; w < problem.wires.size(); ++w) {
      const auto& wire = problem.wires[w];
      EXPECT_LT(layout.column[wire.from], layout.column[wire.to]);
      EXPECT_EQ(static_cast<int>(layout.bends[w].size()),
                layout.column[wire.to] - layout.column[wire.from] - 1);
    }
    for (std::size_t a = 0; a < problem.boxes.size(); ++a) {
      EXPECT_GE(layout.top[a], 0);
      EXPECT_LE(layout.top[a] + problem.boxes[a].height, layout.height + 1e-6);
      for (std::size_t b = a + 1; b < problem.boxes.size(); ++b) {
        if (layout.column[a] != layout.column[b]) continue;
        const bool apart =
            layout.top[a] + problem.boxes[a].height + problem.gap <= layout.top[b] + 1e-6 ||
            layout.top[b] + problem.boxes[b].height + problem.gap <= layout.top[a] + 1e-6;
        EXPECT_TRUE(apart) << "boxes " << a << " and " << b << " of seed " << seed;
      }
      for (const auto& bends : layout.bends) {
        for (const Layout::Bend& bend : bends) {
          EXPECT_TRUE(bend.column != layout.column[a] || bend.height < layout.top[a] ||
                      bend.height > layout.top[a] + problem.boxes[a].height)
              << "a wire runs through a box, seed " << seed;
        }
      }
    }
  }
}

TEST(LayeredLayout, DrawsAChainStraight) {
  LayoutProblem problem;
  for (int i = 0; i < 5; ++i) problem.boxes.push_back({60, 0});
  for (std::size_t i = 1; i < 5; ++i) problem.wires.push_back({i - 1, i, 30, 30});
  const Layout layout = lay_out(problem);
  for (std::size_t i = 0; i < 5; ++i) {
    EXPECT_EQ(layout.column[i], static_cast<int>(i));
    EXPECT_NEAR(layout.top[i], 0, 1e-9);
  }
}

TEST(LayeredLayout, UncrossesWhatNeedNotCross) {
  // Two chains whose second boxes are listed in the other order.
  LayoutProblem problem;
  for (int i = 0; i < 4; ++i) problem.boxes.push_back({50, 0});
  problem.wires = {{0, 3, 25, 25}, {1, 2, 25, 25}};
  const Layout layout = lay_out(problem);
  EXPECT_EQ(layout.top[0] < layout.top[1], layout.top[3] < layout.top[2]);
}

TEST(LayeredLayout, MovesASourceNextToItsReader) {
  LayoutProblem problem;
  for (int i = 0; i < 5; ++i) problem.boxes.push_back({50, 0});
  problem.wires = {{0, 1, 25, 25}, {1, 2, 25, 25}, {2, 4, 25, 10}, {3, 4, 25, 30}};
  EXPECT_EQ(lay_out(problem).column[3], 2);
}

TEST(LayeredLayout, BearsLargeGraphs) {
  const LayoutProblem problem = random_problem(5, 400);
  EXPECT_EQ(lay_out(problem).top.size(), 400U);
}

TEST(LayeredLayout, BearsNothingAtAll) {
  const Layout layout = lay_out({});
  EXPECT_EQ(layout.columns, 0);
  EXPECT_EQ(layout.height, 0);
}

}  // namespace
}  // namespace stope::report
