#include "plugins/metric/path_similarity.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/plugins/metric/drawn_roads.hpp"
#include "tests/plugins/stage_harness.hpp"

extern "C" const stope::StageEntry* stope_stage_Apls();
extern "C" const stope::StageEntry* stope_stage_ShortestPaths();

namespace stope::metric {
namespace {

using stope::testing::error_of;
using stope::testing::StageHarness;

Measures apls(const RoadGraph& roads, const RoadGraph& truth, double spacing = 50) {
  return StageHarness(stope_stage_Apls())
      .input("roads", roads)
      .input("truth", truth)
      .set("spacing", spacing)
      .apply<Measures>();
}

// All distances between places, by cutting the edges there and Floyd and Warshall's algorithm.
std::vector<std::vector<double>> floyd_warshall(const RoadGraph& graph, const GraphLines& lines,
                                                const std::vector<RoadPlace>& places) {
  const std::size_t nodes = graph.nodes.size(), count = nodes + places.size();
  std::vector<std::vector<double>> d(
      count, std::vector<double>(count, std::numeric_limits<double>::infinity()));
  const auto link = [&](std::size_t a, std::size_t b, double length) {
    d[a][b] = d[b][a] = std::min(d[a][b], length);
  };
  for (std::size_t i = 0; i < count; ++i) d[i][i] = 0;
  for (std::uint32_t e = 0; e < graph.edges.size(); ++e) {
    std::vector<std::pair<double, std::size_t>> cuts{{0, graph.edges[e].from}};
    for (std::size_t p = 0; p < places.size(); ++p)
      if (places[p].edge == e) cuts.emplace_back(places[p].along, nodes + p);
    cuts.emplace_back(lines.length(e), graph.edges[e].to);
    std::sort(cuts.begin() + 1, cuts.end() - 1);
    for (std::size_t i = 1; i < cuts.size(); ++i)
      link(cuts[i - 1].second, cuts[i].second, cuts[i].first - cuts[i - 1].first);
  }
  for (std::size_t k = 0; k < count; ++k)
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t j = 0; j < count; ++j) d[i][j] = std::min(d[i][j], d[i][k] + d[k][j]);
  return d;
}

TEST(RoadDistances, AreThoseOfFloydAndWarshall) {
  Random random(5);
  for (int round = 0; round < 30; ++round) {
    const RoadGraph graph = random_roads(random, 8, 9, 100);
    const GraphLines lines(graph);
    RoadDistances distances(graph, lines);
    std::vector<RoadPlace> places;
    for (int i = 0; i < 10; ++i) {
      const auto edge = static_cast<std::uint32_t>(random.below(graph.edges.size()));
      places.push_back({edge, random.uniform(0, lines.length(edge))});
    }
    const auto expected = floyd_warshall(graph, lines, places);
    const std::size_t nodes = graph.nodes.size();
    for (std::size_t i = 0; i < places.size(); ++i) {
      const auto to_nodes = distances.to_nodes(places[i]);
      for (std::size_t n = 0; n < nodes; ++n) {
        if (std::isinf(expected[nodes + i][n])) {
          EXPECT_TRUE(std::isinf(to_nodes[n]));
        } else {
          EXPECT_NEAR(to_nodes[n], expected[nodes + i][n], 1e-9);
        }
      }
      for (std::size_t j = 0; j < places.size(); ++j) {
        const double between = distances.between(places[i], places[j]);
        if (std::isinf(expected[nodes + i][nodes + j])) {
          EXPECT_TRUE(std::isinf(between));
        } else {
          EXPECT_NEAR(between, expected[nodes + i][nodes + j], 1e-9);
        }
      }
    }
  }
}

TEST(GraphLines, TheNearestPlaceIsThatOfTryingAll) {
  Random random(6);
  const RoadGraph graph = random_roads(random, 30, 60, 200);
  const GraphLines lines(graph);
  for (int k = 0; k < 300; ++k) {
    const Vector2 point(random.uniform(-50, 250), random.uniform(-50, 250));
    double best = std::numeric_limits<double>::infinity();
    for (const auto& piece : lines.pieces()) {
      const Vector2 span = piece.b - piece.a;
      const double t = std::clamp((point - piece.a).dot(span) / span.squaredNorm(), 0.0, 1.0);
      best = std::min(best, (piece.a + t * span - point).norm());
    }
    const auto near = lines.nearest(point);
    ASSERT_TRUE(near);
    EXPECT_NEAR(near->distance, best, 1e-9);
    EXPECT_NEAR((lines.position(near->place) - point).norm(), best, 1e-9);
    EXPECT_EQ(lines.nearest(point, 10).has_value(), near->distance <= 10);
  }
}

TEST(Apls, OfAGraphWithItselfIsOne) {
  Random random(2);
  const RoadGraph graph = random_roads(random, 8, 12, 300);
  EXPECT_NEAR(value_of(apls(graph, graph), "apls"), 1, 1e-9);
}

TEST(Apls, AShortenedRoadByHand) {
  // Control points of the truth: 0, 50 and 100 m; the last has no road near it, so two of three
  // ways are missing. Those of the graph, 0, 30 and 60 m, lie on the truth.
  const Measures measures = apls(draw_roads({{{0, 0}, {60, 0}}}), draw_roads({{{0, 0}, {100, 0}}}));
  EXPECT_NEAR(value_of(measures, "apls_truth_onto_roads"), 1.0 / 3, 1e-12);
  EXPECT_NEAR(value_of(measures, "apls_roads_onto_truth"), 1, 1e-12);
  EXPECT_NEAR(value_of(measures, "apls"), 0.5, 1e-12);
}

TEST(Apls, ALongerWayByHand) {
  // Two legs of 60 m instead of 100 m: 1 - 20/100 and 1 - 20/120.
  const RoadGraph bent = draw_roads({{{0, 0}, {50, std::sqrt(1100)}, {100, 0}}});
  const Measures measures = apls(bent, draw_roads({{{0, 0}, {100, 0}}}), 1000);
  EXPECT_NEAR(value_of(measures, "apls_truth_onto_roads"), 0.8, 1e-12);
  EXPECT_NEAR(value_of(measures, "apls_roads_onto_truth"), 5.0 / 6, 1e-12);
  EXPECT_NEAR(value_of(measures, "apls"), 40.0 / 49, 1e-12);
}

TEST(Apls, AMissingRoadOfARingByHand) {
  // A square of 100 m; the graph lacks one side. Of the six pairs of corners the one along the
  // missing side costs min(1, 200/100), all others nothing.
  const RoadGraph square = draw_roads(
      {{{0, 0}, {100, 0}}, {{100, 0}, {100, 100}}, {{100, 100}, {0, 100}}, {{0, 100}, {0, 0}}});
  const RoadGraph open =
      draw_roads({{{0, 0}, {100, 0}}, {{100, 0}, {100, 100}}, {{100, 100}, {0, 100}}});
  const Measures measures = apls(open, square, 1000);
  EXPECT_NEAR(value_of(measures, "apls_truth_onto_roads"), 5.0 / 6, 1e-12);
  // The other way: the pair of open ends, 300 m apart, is 100 m apart in the truth.
  EXPECT_NEAR(value_of(measures, "apls_roads_onto_truth"), 1 - 2.0 / 3 / 6, 1e-12);
}

TEST(Apls, PairsThatTheTruthDoesNotConnectAreLeftOut) {
  const RoadGraph two = draw_roads({{{0, 0}, {40, 0}}, {{0, 90}, {40, 90}}});
  const RoadGraph joined = draw_roads({{{0, 0}, {40, 0}}, {{0, 90}, {40, 90}}, {{0, 0}, {0, 90}}});
  const Measures measures = apls(joined, two, 1000);
  EXPECT_EQ(value_of(measures, "apls_truth_onto_roads"), 1);
  EXPECT_NEAR(value_of(measures, "apls_roads_onto_truth"), 2.0 / 6, 1e-12);
}

TEST(Apls, EmptyGraphsAndTruthsWithoutPairs) {
  const RoadGraph road = draw_roads({{{0, 0}, {40, 0}}});
  EXPECT_EQ(value_of(apls({}, road), "apls"), 0);
  RoadGraph nodes;
  nodes.nodes = {{1, 0, 0, 0}, {2, 5, 0, 0}};
  EXPECT_EQ(value_of(apls(nodes, road), "apls"), 0);
  EXPECT_NE(error_of([&] { apls(road, {}); }).find("has no roads"), std::string::npos);
  const RoadGraph ring = draw_roads({{{0, 0}, {5, 0}, {0, 5}, {0, 0}}});
  EXPECT_NE(error_of([&] { apls(road, ring); }).find("no two connected control points"),
            std::string::npos);
  EXPECT_NE(error_of([&] {
              apls(road, draw_roads({{{0, 0}, {1e9, 0}}}));
            }).find("take too long"),
            std::string::npos);
}

TEST(ShortestPaths, CountsWhatIsLongerShorterAndMissing) {
  const RoadGraph square = draw_roads(
      {{{0, 0}, {100, 0}}, {{100, 0}, {100, 100}}, {{100, 100}, {0, 100}}, {{0, 100}, {0, 0}}});
  const auto measure = [&](const RoadGraph& roads) {
    return StageHarness(stope_stage_ShortestPaths())
        .input("roads", roads)
        .input("truth", square)
        .set("pairs", std::int64_t{6000})
        .apply<Measures>();
  };
  EXPECT_EQ(value_of(measure(square), "shortest_paths_correct"), 1);
  // One of six pairs is 300 m instead of 100 m apart.
  const Measures open =
      measure(draw_roads({{{0, 0}, {100, 0}}, {{100, 0}, {100, 100}}, {{100, 100}, {0, 100}}}));
  EXPECT_NEAR(value_of(open, "shortest_paths_too_long"), 1.0 / 6, 0.02);
  EXPECT_NEAR(value_of(open, "shortest_paths_correct"), 5.0 / 6, 0.02);
  // One of four corners is nowhere near: half of the pairs have it.
  const Measures corner = measure(draw_roads({{{0, 0}, {100, 0}}, {{100, 0}, {100, 100}}}));
  EXPECT_NEAR(value_of(corner, "shortest_paths_missing"), 0.5, 0.03);
  EXPECT_EQ(value_of(measure({}), "shortest_paths_missing"), 1);
}

}  // namespace
}  // namespace stope::metric
