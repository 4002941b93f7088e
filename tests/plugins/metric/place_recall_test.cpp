#include "plugins/metric/place_recall.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "plugins/metric/node_matching.hpp"
#include "tests/plugins/metric/drawn_roads.hpp"
#include "tests/plugins/stage_harness.hpp"

extern "C" const stope::StageEntry* stope_stage_DeadEnds();
extern "C" const stope::StageEntry* stope_stage_Junctions();

namespace stope::metric {
namespace {

using stope::testing::StageHarness;

// The size of the greatest matching, by trying everything.
std::size_t greatest(const std::vector<Vector2>& truth, const std::vector<Vector2>& found,
                     double within, std::size_t from, unsigned used) {
  if (from == truth.size()) return 0;
  std::size_t best = greatest(truth, found, within, from + 1, used);
  for (std::size_t f = 0; f < found.size(); ++f) {
    if ((used >> f & 1U) || (truth[from] - found[f]).norm() > within) continue;
    best = std::max(best, 1 + greatest(truth, found, within, from + 1, used | 1U << f));
  }
  return best;
}

TEST(MatchPoints, FindsAsManyPairsAsCanBe) {
  Random random(1);
  const auto points = [&](std::uint64_t count) {
    std::vector<Vector2> list;
    for (std::uint64_t i = 0; i < count; ++i)
      list.emplace_back(random.uniform(0, 10), random.uniform(0, 10));
    return list;
  };
  for (int round = 0; round < 200; ++round) {
    const auto truth = points(random.below(7)), found = points(random.below(7));
    const auto pairs = match_points(truth, found, 3);
    EXPECT_EQ(pairs.size(), greatest(truth, found, 3, 0, 0));
    std::vector<std::uint32_t> used;
    for (const MatchedPair& pair : pairs) {
      EXPECT_LE(pair.distance, 3);
      EXPECT_EQ(pair.distance, (truth[pair.truth] - found[pair.found]).norm());
      EXPECT_EQ(std::count(used.begin(), used.end(), pair.found), 0);
      used.push_back(pair.found);
    }
  }
}

// A cross of four roads of 50 m.
RoadGraph cross(double shift = 0) {
  return draw_roads({{{shift, 0}, {50, 0}},
                     {{shift, 0}, {0, 50}},
                     {{shift, 0}, {-50, 0}},
                     {{shift, 0}, {0, -50}}});
}

Measures measure(const StageEntry* stage, const RoadGraph& roads, const RoadGraph& truth,
                 double within) {
  return StageHarness(stage)
      .input("roads", roads)
      .input("truth", truth)
      .set("within", within)
      .apply<Measures>();
}

TEST(DeadEnds, AreFoundOnceEach) {
  // Of four dead ends two are found, one 3 m off; a third end of the graph is a spur.
  const RoadGraph roads = draw_roads({{{-50, 0}, {53, 0}}, {{0, 0}, {0, 20}}, {{0, 0}, {1, 20}}});
  const Measures measures = measure(stope_stage_DeadEnds(), roads, cross(), 5);
  EXPECT_DOUBLE_EQ(value_of(measures, "dead_end_recall"), 0.5);
  EXPECT_DOUBLE_EQ(value_of(measures, "dead_end_precision"), 0.5);
  EXPECT_DOUBLE_EQ(value_of(measures, "dead_end_distance_mean"), 1.5);
  EXPECT_DOUBLE_EQ(value_of(measures, "dead_end_distance_max"), 3);
}

TEST(DeadEnds, DistancesOfNothingAreNoNumberAndNotPerfect) {
  const RoadGraph ring = draw_roads({{{0, 0}, {20, 0}, {0, 20}, {0, 0}}});
  for (const auto& [stage, what] : {std::pair(stope_stage_DeadEnds(), std::string("dead_end")),
                                    {stope_stage_Junctions(), std::string("junction")}}) {
    const Measures measures = measure(stage, ring, cross(), 5);
    EXPECT_EQ(value_of(measures, what + "_recall"), 0);
    EXPECT_TRUE(std::isnan(value_of(measures, what + "_distance_mean"))) << what;
    EXPECT_TRUE(std::isnan(value_of(measures, what + "_distance_max"))) << what;
  }
}

TEST(DeadEnds, OfARingThereAreNone) {
  const RoadGraph ring = draw_roads({{{0, 0}, {20, 0}, {0, 20}, {0, 0}}});
  const Measures measures = measure(stope_stage_DeadEnds(), ring, ring, 5);
  EXPECT_EQ(value_of(measures, "dead_end_recall"), 1);
  EXPECT_EQ(value_of(measures, "dead_end_precision"), 1);
}

TEST(Junctions, MatchWithinTheGivenDistance) {
  EXPECT_EQ(value_of(measure(stope_stage_Junctions(), cross(4), cross(), 5), "junction_f1"), 1);
  EXPECT_EQ(value_of(measure(stope_stage_Junctions(), cross(4), cross(), 3), "junction_f1"), 0);
}

TEST(Junctions, ASplitJunctionIsHalfRight) {
  // The cross as two junctions of three roads, 2 m apart: one matches, the other is too many.
  const RoadGraph split = draw_roads({{{-1, 0}, {1, 0}},
                                      {{1, 0}, {50, 0}},
                                      {{1, 0}, {0, 50}},
                                      {{-1, 0}, {-50, 0}},
                                      {{-1, 0}, {0, -50}}});
  const Measures measures = measure(stope_stage_Junctions(), split, cross(), 5);
  EXPECT_EQ(value_of(measures, "junction_recall"), 1);
  EXPECT_EQ(value_of(measures, "junction_precision"), 0.5);
  EXPECT_NEAR(value_of(measures, "junction_f1"), 2.0 / 3, 1e-12);
}

TEST(Junctions, AnEmptyGraphHasNone) {
  const Measures measures = measure(stope_stage_Junctions(), {}, cross(), 5);
  EXPECT_EQ(value_of(measures, "junction_f1"), 0);
  EXPECT_EQ(value_of(measures, "junction_precision"), 1);
}

}  // namespace
}  // namespace stope::metric
