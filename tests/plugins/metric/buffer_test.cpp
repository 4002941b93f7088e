#include <gtest/gtest.h>

#include "plugins/metric/length_within.hpp"
#include "tests/plugins/metric/drawn_roads.hpp"
#include "tests/plugins/stage_harness.hpp"

extern "C" const stope::StageEntry* stope_stage_Buffer();

namespace stope::metric {
namespace {

using stope::testing::StageHarness;

Measures buffer(const RoadGraph& roads, const RoadGraph& truth, double size) {
  return StageHarness(stope_stage_Buffer())
      .input("roads", roads)
      .input("truth", truth)
      .set("buffer", size)
      .apply<Measures>();
}

const RoadGraph kStraight = draw_roads({{{0, 0}, {100, 0}}});

TEST(Buffer, AParallelRoadIsRightOrWrongAltogether) {
  const RoadGraph beside = draw_roads({{{0, 1.5}, {100, 1.5}}});
  const Measures near = buffer(beside, kStraight, 2);
  EXPECT_DOUBLE_EQ(value_of(near, "completeness"), 1);
  EXPECT_DOUBLE_EQ(value_of(near, "correctness"), 1);
  EXPECT_DOUBLE_EQ(value_of(near, "quality"), 1);
  EXPECT_DOUBLE_EQ(value_of(buffer(beside, kStraight, 1), "quality"), 0);
}

TEST(Buffer, ARoadTooLongIsRightToTheEndOfTheBuffer) {
  // 150 m of which 100 m are true and 2 m more within the buffer of the end.
  const Measures measures = buffer(draw_roads({{{0, 0}, {150, 0}}}), kStraight, 2);
  EXPECT_NEAR(value_of(measures, "correctness"), 102.0 / 150, 1e-12);
  EXPECT_DOUBLE_EQ(value_of(measures, "completeness"), 1);
  EXPECT_NEAR(value_of(measures, "quality"), 102.0 / 150, 1e-12);
}

TEST(Buffer, AMissingHalfLowersCompletenessAndQuality) {
  const Measures measures = buffer(draw_roads({{{0, 0}, {50, 0}}}), kStraight, 2);
  EXPECT_NEAR(value_of(measures, "completeness"), 0.52, 1e-12);
  EXPECT_DOUBLE_EQ(value_of(measures, "correctness"), 1);
  EXPECT_NEAR(value_of(measures, "quality"), 50.0 / 98, 1e-12);
}

TEST(Buffer, ACrossingCountsTheBuffersWidth) {
  const Measures measures = buffer(draw_roads({{{50, -50}, {50, 50}}}), kStraight, 2);
  EXPECT_NEAR(value_of(measures, "correctness"), 0.04, 1e-12);
  EXPECT_NEAR(value_of(measures, "completeness"), 0.04, 1e-12);
}

TEST(Buffer, NoShareIsAboveOne) {
  Random random(5);
  for (int round = 0; round < 50; ++round) {
    const RoadGraph roads = random_roads(random, 12, 18, 300);
    const Measures measures = buffer(roads, roads, 2);
    for (const char* name : {"completeness", "correctness", "quality"}) {
      EXPECT_LE(value_of(measures, name), 1) << name;
      EXPECT_GT(value_of(measures, name), 1 - 1e-12) << name;
    }
  }
}

TEST(Buffer, AgreesWithFineSamples) {
  Random random(3);
  for (int round = 0; round < 20; ++round) {
    const RoadGraph a = random_roads(random, 6, 6, 60), b = random_roads(random, 6, 6, 60);
    const GraphLines lines(a), other(b);
    double sampled = 0;
    visit_samples(lines, 0.01, [&](const Vector2& point, double length) {
      for (const auto& piece : other.pieces()) {
        const Vector2 span = piece.b - piece.a;
        const double t = std::clamp((point - piece.a).dot(span) / span.squaredNorm(), 0.0, 1.0);
        if ((piece.a + t * span - point).norm() > 3) continue;
        sampled += length;
        return;
      }
    });
    EXPECT_NEAR(length_within(lines, other, 3), sampled, 0.3);
  }
}

TEST(Buffer, EmptyGraphsAndEmptyTruth) {
  const Measures measures = buffer({}, kStraight, 2);
  EXPECT_EQ(value_of(measures, "completeness"), 0);
  EXPECT_EQ(value_of(measures, "correctness"), 1);
  EXPECT_EQ(value_of(measures, "quality"), 0);
  EXPECT_NE(stope::testing::error_of([] { buffer(kStraight, {}, 2); }).find("has no roads"),
            std::string::npos);
}

TEST(Buffer, RefusesGraphsThatAreNotWhole) {
  const auto sentence = [](RoadGraph graph) {
    return stope::testing::error_of([&] { buffer(graph, kStraight, 2); });
  };
  RoadGraph graph = kStraight;
  graph.vertices[1].x = std::nan("");
  EXPECT_NE(sentence(graph).find("vertex 1 of the graph at 'roads' lies at (nan, 0)"),
            std::string::npos);
  graph = kStraight;
  graph.edges[0].to = 7;
  EXPECT_EQ(sentence(graph), "edge 0 of the graph at 'roads' joins node 7, but there are 2 nodes");
  graph = kStraight;
  graph.edges[0].vertex_count = 9;
  EXPECT_NE(sentence(graph).find("has the vertices 0 to 9 of 2"), std::string::npos);
}

}  // namespace
}  // namespace stope::metric
