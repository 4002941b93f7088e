#include <gtest/gtest.h>

#include <cmath>

#include "plugins/metric/travel_samples.hpp"
#include "tests/plugins/metric/drawn_roads.hpp"
#include "tests/plugins/stage_harness.hpp"

extern "C" const stope::StageEntry* stope_stage_Topo();

namespace stope::metric {
namespace {

using stope::testing::error_of;

Measures topo(const RoadGraph& roads, const RoadGraph& truth) {
  return stope::testing::StageHarness(stope_stage_Topo())
      .input("roads", roads)
      .input("truth", truth)
      .apply<Measures>();
}

std::size_t samples(const RoadGraph& graph, std::uint32_t node, double interval, double reach) {
  const MeasuredGraph measured(graph);
  return travel_samples(measured, measured.distances.place_of_node(node), interval, reach).size();
}

TEST(TravelSamples, OfACrossByHand) {
  const RoadGraph cross =
      draw_roads({{{0, 0}, {60, 0}}, {{0, 0}, {0, 60}}, {{0, 0}, {-60, 0}}, {{0, 0}, {0, -60}}});
  ASSERT_EQ(cross.nodes[2].x, 0);
  ASSERT_EQ(cross.nodes[2].y, 0);
  EXPECT_EQ(samples(cross, 2, 30, 150), 8U);  // two on each arm
  EXPECT_EQ(samples(cross, 0, 30, 150), 8U);  // 30, the centre, and 90 and 120 on three arms
  EXPECT_EQ(samples(cross, 0, 30, 100), 5U);
}

TEST(TravelSamples, OfARingTheFarSideIsThereOnce) {
  const RoadGraph ring = draw_roads({{{0, 0}, {30, 0}, {30, 30}, {0, 30}, {0, 0}}});
  EXPECT_EQ(samples(ring, 0, 30, 150), 3U);
  EXPECT_EQ(samples(ring, 0, 25, 150), 4U);
}

TEST(TravelSamples, CrossEveryMultipleOfTheInterval) {
  Random random(7);
  for (int round = 0; round < 20; ++round) {
    const RoadGraph graph = random_roads(random, 7, 9, 100);
    MeasuredGraph measured(graph);
    const auto edge = static_cast<std::uint32_t>(random.below(graph.edges.size()));
    const RoadPlace start{edge, random.uniform(0, measured.lines.length(edge))};
    // Counted by walking every edge in steps of a millimetre's order.
    std::size_t crossings = 0;
    for (std::uint32_t e = 0; e < graph.edges.size(); ++e) {
      const double length = measured.lines.length(e);
      const int steps = static_cast<int>(length * 100);
      double before = measured.distances.between(start, {e, 0});
      for (int k = 1; k <= steps; ++k) {
        const double here = measured.distances.between(start, {e, k * length / steps});
        if (std::min(before, here) <= 150 && std::floor(before / 30) != std::floor(here / 30))
          ++crossings;
        before = here;
      }
    }
    const auto points = travel_samples(measured, start, 30, 150);
    EXPECT_EQ(points.size(), crossings);
    for (const Vector2& point : points) EXPECT_LT(measured.lines.nearest(point)->distance, 1e-9);
  }
}

const RoadGraph kStraight = draw_roads({{{0, 0}, {300, 0}}});

TEST(Topo, ARoadWithinTheHolesIsRight) {
  const Measures measures = topo(draw_roads({{{0, 3}, {300, 3}}}), kStraight);
  EXPECT_EQ(value_of(measures, "topo_f1"), 1);
}

TEST(Topo, ARoadBesideTheHolesIsNotSeen) {
  const Measures measures = topo(draw_roads({{{0, 5}, {300, 5}}}), kStraight);
  EXPECT_EQ(value_of(measures, "topo_recall"), 0);
  EXPECT_EQ(value_of(measures, "topo_precision"), 0);
  EXPECT_EQ(value_of(measures, "topo_f1"), 0);
}

TEST(Topo, AShortRoadByHand) {
  // Five holes from each end. From the left, marbles at 30, 60 and 90 m; at the right no road.
  const Measures measures = topo(draw_roads({{{0, 0}, {100, 0}}}), kStraight);
  EXPECT_NEAR(value_of(measures, "topo_recall"), 0.3, 1e-12);
  EXPECT_EQ(value_of(measures, "topo_precision"), 1);
  EXPECT_NEAR(value_of(measures, "topo_f1"), 0.6 / 1.3, 1e-12);
}

TEST(Topo, ASpurByHand) {
  // Ten holes. The spur at 50 m adds the marbles at 60 and 90 m of travel from the left.
  const Measures measures =
      topo(draw_roads({{{0, 0}, {50, 0}}, {{50, 0}, {300, 0}}, {{50, 0}, {50, 40}}}), kStraight);
  EXPECT_EQ(value_of(measures, "topo_recall"), 1);
  EXPECT_NEAR(value_of(measures, "topo_precision"), 10.0 / 12, 1e-12);
}

TEST(Topo, AGapThatTheMapDoesNotShowIsSeen) {
  // 1 m is missing at 75 m: beyond it nothing is reached from the left, and from the right
  // 150 m of travel end before it.
  const Measures measures = topo(draw_roads({{{0, 0}, {75, 0}}, {{76, 0}, {300, 0}}}), kStraight);
  EXPECT_NEAR(value_of(measures, "topo_recall"), 0.7, 1e-12);
  EXPECT_EQ(value_of(measures, "topo_precision"), 1);
}

TEST(Topo, EmptyGraphsAndShortTruths) {
  EXPECT_EQ(value_of(topo({}, kStraight), "topo_f1"), 0);
  EXPECT_NE(error_of([] { topo(kStraight, {}); }).find("has no roads"), std::string::npos);
  EXPECT_NE(error_of([] {
              topo(kStraight, draw_roads({{{0, 0}, {20, 0}}}));
            }).find("nothing to"),
            std::string::npos);
}

}  // namespace
}  // namespace stope::metric
