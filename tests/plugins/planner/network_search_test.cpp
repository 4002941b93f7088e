// All searches on flat graphs against Dijkstra's, which is itself checked against costs relaxed
// until nothing changes (Bellman and Ford).
#include <gtest/gtest.h>

#include "plugins/planner/dijkstra_search.hpp"
#include "plugins/planner/hierarchy_search.hpp"
#include "plugins/planner/hierarchy_sweep.hpp"
#include "plugins/planner/landmark_search.hpp"
#include "plugins/planner/reroute_search.hpp"
#include "stope/random.hpp"
#include "tests/benchmarks/routing/test_networks.hpp"

namespace stope::planner {
namespace {

// Any directed graph: loops, parallel arcs, parts that cannot be reached, equal costs.
std::vector<ArcBetween> random_arcs(Random& random, std::uint32_t nodes, std::uint64_t count) {
  std::vector<ArcBetween> arcs;
  for (std::uint64_t i = 0; i < count; ++i) {
    arcs.push_back({static_cast<std::uint32_t>(random.below(nodes)),
                    static_cast<std::uint32_t>(random.below(nodes)),
                    static_cast<std::uint32_t>(random.below(6))});
    if (random.below(3) != 0) arcs.push_back({arcs.back().to, arcs.back().from, arcs.back().cost});
  }
  return arcs;
}

std::vector<WayEnd> random_ends(Random& random, std::uint32_t nodes) {
  std::vector<WayEnd> ends(1 + random.below(2));
  for (WayEnd& end : ends)
    end = {static_cast<std::uint32_t>(random.below(nodes)), random.below(10)};
  return ends;
}

CostChanges random_changes(Random& random, const SearchGraph& graph) {
  CostChanges changes;
  for (std::uint32_t arc = 0; arc < graph.arc_count(); ++arc) {
    const std::uint64_t draw = random.below(10);
    if (draw == 0) changes.block(arc);
    if (draw == 1) changes.raise(arc, graph.arc(arc).cost + random.below(20));
  }
  return changes;
}

WayCost relaxed_cost(const SearchGraph& graph, const std::vector<WayEnd>& sources,
                     const std::vector<WayEnd>& targets, const CostChanges& changes) {
  std::vector<WayCost> costs(graph.node_count(), kNoWay);
  for (const WayEnd& source : sources)
    costs[source.node] = std::min(costs[source.node], source.cost);
  for (bool changed = true; changed;) {
    changed = false;
    for (std::uint32_t arc = 0; arc < graph.arc_count(); ++arc) {
      const WayCost more = changes.cost(arc, graph.arc(arc).cost);
      const WayCost here = costs[graph.source(arc)];
      if (here == kNoWay || more == kNoWay || here + more >= costs[graph.arc(arc).to]) continue;
      costs[graph.arc(arc).to] = here + more;
      changed = true;
    }
  }
  WayCost best = kNoWay;
  for (const WayEnd& target : targets)
    if (costs[target.node] != kNoWay) best = std::min(best, costs[target.node] + target.cost);
  return best;
}

// Whether the arcs hang together from a source to a target and cost what the way says.
void expect_sound(const SearchGraph& graph, const std::vector<WayEnd>& sources,
                  const std::vector<WayEnd>& targets, const CostChanges& changes, const Way& way) {
  std::uint32_t node = way.source;
  WayCost inside = 0;
  for (const std::uint32_t arc : way.arcs) {
    ASSERT_EQ(graph.source(arc), node);
    ASSERT_NE(changes.cost(arc, graph.arc(arc).cost), kNoWay);
    inside += changes.cost(arc, graph.arc(arc).cost);
    node = graph.arc(arc).to;
  }
  EXPECT_EQ(node, way.target);
  WayCost least = kNoWay;
  for (const WayEnd& source : sources)
    for (const WayEnd& target : targets)
      if (source.node == way.source && target.node == way.target)
        least = std::min(least, source.cost + inside + target.cost);
  EXPECT_EQ(least, way.cost);
}

TEST(NetworkSearch, AllFindWaysAsCheapAsRelaxationDoes) {
  Random random(3);
  int found = 0, none = 0, corridors = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const auto nodes = static_cast<std::uint32_t>(1 + random.below(40));
    const SearchGraph graph(
        nodes, random_arcs(random, nodes, random.below((trial % 4 < 2 ? 3 : 12) * nodes)));
    // With places dense ones are ordered by nested dissection; any places will do.
    std::vector<NodePlace> places;
    if (trial % 2 == 0) {
      for (std::uint32_t node = 0; node < nodes; ++node)
        places.push_back(
            {static_cast<float>(random.uniform()), static_cast<float>(random.uniform())});
    }
    const ContractionHierarchy hierarchy(graph, places);
    const Landmarks landmarks(graph, 5);
    DijkstraSearch dijkstra(graph);
    const auto by_rank = landmarks_by_rank(hierarchy);
    HierarchySearch by_hierarchy(hierarchy), in_corridor(hierarchy, by_rank ? &*by_rank : nullptr);
    RerouteSearch reroute(graph, hierarchy);
    RerouteSearch reroute_in_corridor(graph, hierarchy, by_rank ? &*by_rank : nullptr);
    LandmarkSearch by_landmarks(graph, landmarks);
    corridors += by_rank.has_value();
    for (int query = 0; query < 10; ++query) {
      const auto sources = random_ends(random, nodes), targets = random_ends(random, nodes);
      const CostChanges none_changed, changed = random_changes(random, graph);
      for (const CostChanges* changes : {&none_changed, &changed}) {
        const WayCost truth = relaxed_cost(graph, sources, targets, *changes);
        ++(truth == kNoWay ? none : found);
        std::vector<Way> ways{dijkstra.find(sources, targets, *changes),
                              reroute.find(sources, targets, *changes),
                              reroute_in_corridor.find(sources, targets, *changes),
                              by_landmarks.find(sources, targets, *changes)};
        if (changes == &none_changed) {
          ways.push_back(by_hierarchy.find(sources, targets));
          ways.push_back(in_corridor.find(sources, targets));
        }
        for (const Way& way : ways) {
          ASSERT_EQ(way.cost, truth) << "trial " << trial << " search " << &way - ways.data();
          if (way.found()) expect_sound(graph, sources, targets, *changes, way);
        }
      }
    }
  }
  EXPECT_GT(found, 1000);
  EXPECT_GT(none, 500);
  EXPECT_GT(corridors, 20);
}

// 10 000 pairs on each of three networks of some thousand nodes.
TEST(NetworkSearch, EveryOneOfManyWaysIsAsCheapAsDijkstras) {
  const TestNetwork networks[] = {lattice(40, 1, 1), lattice(50, 2, 2), road_like(40, 3)};
  for (const TestNetwork& network : networks) {
    const SearchGraph graph = network.graph();
    const ContractionHierarchy hierarchy(graph, network.places());
    const Landmarks landmarks(graph, 8);
    DijkstraSearch dijkstra(graph);
    const auto by_rank = landmarks_by_rank(hierarchy);
    HierarchySearch by_hierarchy(hierarchy), in_corridor(hierarchy, by_rank ? &*by_rank : nullptr);
    RerouteSearch reroute(graph, hierarchy);
    RerouteSearch reroute_in_corridor(graph, hierarchy, by_rank ? &*by_rank : nullptr);
    LandmarkSearch by_landmarks(graph, landmarks);
    Random random(5);
    std::size_t wrong = 0;
    for (int i = 0; i < 100; ++i) {
      const auto source = static_cast<std::uint32_t>(random.below(graph.node_count()));
      const std::vector<WayCost> truth = dijkstra.costs(source);
      for (int k = 0; k < 100; ++k) {
        const WayEnd from{source, 0};
        const WayEnd to{static_cast<std::uint32_t>(random.below(graph.node_count())), 0};
        const Way way = by_hierarchy.find({&from, 1}, {&to, 1});
        wrong += way.cost != truth[to.node];
        wrong += in_corridor.find({&from, 1}, {&to, 1}).cost != truth[to.node];
        wrong += by_landmarks.find({&from, 1}, {&to, 1}).cost != truth[to.node];
        if (k % 10 != 0 || way.arcs.empty()) continue;
        CostChanges changes;
        changes.block(way.arcs[way.arcs.size() / 2]);
        const WayCost round = dijkstra.find({&from, 1}, {&to, 1}, changes).cost;
        wrong += reroute.find({&from, 1}, {&to, 1}, changes).cost != round;
        wrong += reroute_in_corridor.find({&from, 1}, {&to, 1}, changes).cost != round;
        wrong += by_landmarks.find({&from, 1}, {&to, 1}, changes).cost != round;
      }
    }
    EXPECT_EQ(wrong, 0U);
  }
}

TEST(NetworkSearch, ASweepTellsAllCostsThatDijkstrasDoes) {
  // One whose hierarchy has chains, one without, one in two parts.
  const std::vector<ArcBetween> two_parts{{0, 1, 5}, {1, 2, 7}, {2, 0, 1}, {3, 4, 2}};
  TestNetwork apart;
  apart.arcs = two_parts;
  apart.x = apart.y = {0, 1, 2, 3, 4};
  for (const TestNetwork& network : {lattice(30, 2, 2), road_like(20, 3), apart}) {
    const SearchGraph graph = network.graph();
    const ContractionHierarchy hierarchy(graph, network.places());
    DijkstraSearch dijkstra(graph);
    for (const std::uint32_t node : {0U, graph.node_count() / 2}) {
      for (const bool against : {false, true}) {
        const auto truth = dijkstra.costs(node, against);
        const auto swept = sweep_costs(hierarchy, hierarchy.rank(node), against);
        for (std::uint32_t other = 0; other < graph.node_count(); ++other)
          ASSERT_EQ(swept[hierarchy.rank(other)], truth[other]) << node << " and " << other;
      }
    }
  }
}

// The only other way is so long that no guess of a corridor holds it.
TEST(NetworkSearch, ReroutingFindsTheLongestWayRound) {
  TestNetwork network = lattice(40, 1, 1);
  // A wall with one gate; it ends at the last row.
  for (ArcBetween& arc : network.arcs) {
    const std::uint32_t west = std::min(arc.from, arc.to), east = std::max(arc.from, arc.to);
    const std::uint32_t row = west / 40;
    if (west % 40 == 19 && east == west + 1 && row != 20 && row != 39) arc.cost = 100'000'000;
  }
  const SearchGraph graph = network.graph();
  const ContractionHierarchy hierarchy(graph, network.places());
  const auto by_rank = landmarks_by_rank(hierarchy);
  ASSERT_TRUE(by_rank);
  RerouteSearch reroute(graph, hierarchy, &*by_rank);
  const WayEnd from{20 * 40 + 19, 0}, to{20 * 40 + 20, 0};
  CostChanges changes;
  for (std::uint32_t arc = 0; arc < graph.arc_count(); ++arc)
    if (graph.source(arc) == from.node && graph.arc(arc).to == to.node) changes.block(arc);
  EXPECT_EQ(reroute.find({&from, 1}, {&to, 1}, {}).cost, 10'000U);
  const Way round = reroute.find({&from, 1}, {&to, 1}, changes);
  EXPECT_EQ(round.cost, 39 * 10'000U);
  expect_sound(graph, {from}, {to}, changes, round);
}

TEST(NetworkSearch, GivesTheSameWayEachTimeItIsAsked) {
  const SearchGraph graph = lattice(30, 1, 1).graph();  // equal ways everywhere
  const ContractionHierarchy hierarchy(graph), again(graph);
  const WayEnd from{31, 0}, to{815, 0};
  HierarchySearch search(hierarchy), other(again);
  const Way first = search.find({&from, 1}, {&to, 1});
  search.find({&to, 1}, {&from, 1});
  EXPECT_EQ(search.find({&from, 1}, {&to, 1}).arcs, first.arcs);
  EXPECT_EQ(other.find({&from, 1}, {&to, 1}).arcs, first.arcs);
}

TEST(NetworkSearch, ReroutingLooksRoundOnlyAtWhatIsBlocked) {
  const TestNetwork network = lattice(61, 1, 1);
  const SearchGraph graph = network.graph();
  const ContractionHierarchy hierarchy(graph, network.places());
  HierarchySearch search(hierarchy);
  RerouteSearch reroute(graph, hierarchy);
  const auto settled_round = [&](const WayEnd& from, const WayEnd& to, WayCost dearer) {
    const Way way = search.find({&from, 1}, {&to, 1});
    CostChanges changes;
    changes.block(way.arcs[way.arcs.size() / 2]);
    const Way round = reroute.find({&from, 1}, {&to, 1}, changes);
    EXPECT_EQ(round.cost, way.cost + dearer);
    expect_sound(graph, {from}, {to}, changes, round);
    return round.settled;
  };
  // From corner to corner there are ways as cheap beside the piece; along a row there are none, and
  // all nodes before the piece might be where to turn off.
  EXPECT_LT(settled_round({0, 0}, {61 * 61 - 1, 0}, 0), 20U);
  EXPECT_LT(settled_round({30 * 61, 0}, {30 * 61 + 60, 0}, 20'000), 45U);
}

TEST(NetworkSearch, WaysTooLongForTheHierarchyAreRefused) {
  const std::vector<ArcBetween> arcs{{0, 1, 4'000'000'000U}, {1, 2, 4'000'000'000U}};
  const SearchGraph graph(3, arcs);
  EXPECT_NO_THROW(DijkstraSearch(graph).costs(0));
  EXPECT_ANY_THROW(Landmarks(graph, 2));
}

}  // namespace
}  // namespace stope::planner
