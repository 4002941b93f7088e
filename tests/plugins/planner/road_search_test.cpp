#include "plugins/planner/road_search.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "plugins/planner/road_router.hpp"
#include "tests/plugins/planner/test_roads.hpp"

namespace stope::planner {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// The truth, by another way: every road cut at its vertices and at both places into straight pieces
// that are relaxed until nothing changes (Bellman and Ford).
class BruteForce {
 public:
  BruteForce(const RoadGraph& graph, const RoadRules& rules, RoadPlace start, RoadPlace goal,
             const RoadChanges& changes = {})
      : rules_(rules) {
    count_ = graph.nodes.size();
    const std::size_t start_spot = count_++, goal_spot = count_++;
    for (std::uint32_t e = 0; e < graph.edges.size(); ++e) {
      const RoadEdge& edge = graph.edges[e];
      if (edge.closed != 0) continue;
      const auto line = graph.polyline(edge);
      std::vector<Spot> spots;
      double along = 0;
      for (std::size_t i = 0; i < line.size(); ++i) {
        if (i > 0) along += std::hypot(line[i].x - line[i - 1].x, line[i].y - line[i - 1].y);
        const std::size_t name = i == 0 ? edge.from : i + 1 == line.size() ? edge.to : count_++;
        spots.push_back({along, name, line[i].clearance});
      }
      for (const auto& [place, name] : {std::pair{start, start_spot}, {goal, goal_spot}}) {
        if (place.edge == e) insert(spots, place.along, name);
      }
      for (std::size_t i = 1; i < spots.size(); ++i) {
        if (!changes.blocked(e, spots[i - 1].along, spots[i].along))
          join(edge, spots[i - 1], spots[i], changes.factor(e));
      }
    }
    std::vector<double> costs(count_, kInfinity);
    costs[start_spot] = 0;
    for (bool changed = true; changed;) {
      changed = false;
      for (const Piece& piece : pieces_) {
        if (costs[piece.from] + piece.cost < costs[piece.to] - 1e-12) {
          costs[piece.to] = costs[piece.from] + piece.cost;
          changed = true;
        }
      }
    }
    cost = costs[goal_spot];
  }
  double cost;

 private:
  struct Spot {
    double along;
    std::size_t name;
    double clearance;
  };
  struct Piece {
    std::size_t from, to;
    double cost;
  };

  static void insert(std::vector<Spot>& spots, double along, std::size_t name) {
    std::size_t i = 1;
    while (i + 1 < spots.size() && spots[i].along < along) ++i;
    spots.insert(spots.begin() + static_cast<std::ptrdiff_t>(i), {along, name, spots[i].clearance});
  }
  void join(const RoadEdge& edge, const Spot& a, const Spot& b, double factor) {
    // Clearance is the same all along a test road.
    const double penalty = std::max(0.0, 1 - edge.min_clearance / rules_.comfortable_clearance);
    const double cost = factor * (b.along - a.along) * (1 + rules_.clearance_weight * penalty);
    if (edge.direction != RoadDirection::kBackward) pieces_.push_back({a.name, b.name, cost});
    if (edge.direction != RoadDirection::kForward) pieces_.push_back({b.name, a.name, cost});
  }

  RoadRules rules_;
  std::size_t count_ = 0;
  std::vector<Piece> pieces_;
};

// Whether the legs hang together, run along permitted directions and cost what the route says.
void expect_sound(const RoadNetwork& network, const Route& route, RoadPlace start, RoadPlace goal,
                  const RoadChanges& changes) {
  double cost = 0;
  RoadVertex here = network.at(start);
  for (const RouteLeg& leg : route.legs) {
    const RoadVertex begin = network.at({leg.edge, leg.from});
    EXPECT_NEAR(std::hypot(begin.x - here.x, begin.y - here.y), 0, 1e-9);
    if (leg.to > leg.from) {
      EXPECT_TRUE(network.forward(leg.edge));
    }
    if (leg.to < leg.from) {
      EXPECT_TRUE(network.backward(leg.edge));
    }
    EXPECT_TRUE(leg.from == leg.to || !changes.blocked(leg.edge, leg.from, leg.to));
    cost += changes.factor(leg.edge) * network.cost(leg.edge, leg.from, leg.to);
    here = network.at({leg.edge, leg.to});
  }
  const RoadVertex end = network.at(goal);
  EXPECT_NEAR(std::hypot(end.x - here.x, end.y - here.y), 0, 1e-9);
  EXPECT_NEAR(cost, route.cost, 1e-9);
}

// Some roads dearer, some closed, some cut halfway.
RoadChanges random_changes(Random& random, const RoadNetwork& network) {
  RoadChanges changes;
  for (std::uint32_t e = 0; e < network.graph().edges.size(); ++e) {
    const std::uint64_t draw = random.below(8);
    if (draw == 0) changes.close(e);
    if (draw == 1) changes.cut(e, network.length(e) * random.uniform());
    if (draw == 2) changes.raise(e, random.uniform(1, 5));
  }
  return changes;
}

void expect_cheapest_ways(RouteSearch search, bool changed) {
  Random random(7);
  int found = 0, none = 0;
  for (int trial = 0; trial < 400; ++trial) {
    const auto nodes = static_cast<std::uint32_t>(2 + random.below(12));
    const RoadGraph graph =
        random_roads(random, nodes, static_cast<std::uint32_t>(1 + random.below(2 * nodes)));
    const RoadRules rules{0, 10, trial % 2 == 0 ? 0.0 : 3.0};
    const RoadNetwork network(graph, rules);
    RoadRouter router(network, search);
    for (int query = 0; query < 4; ++query) {
      const auto place = [&]() -> RoadPlace {
        const auto edge = static_cast<std::uint32_t>(random.below(graph.edges.size()));
        return {edge, network.length(edge) * random.uniform()};
      };
      const RoadPlace start = place(), goal = place();
      if (!network.usable(start.edge) || !network.usable(goal.edge)) continue;
      const RoadChanges changes = changed ? random_changes(random, network) : RoadChanges();
      const BruteForce truth(graph, rules, start, goal, changes);
      const auto route = router.find(start, goal, changes);
      ASSERT_EQ(route.has_value(), std::isfinite(truth.cost)) << "trial " << trial;
      ++(route ? found : none);
      if (!route) continue;
      // Costs are rounded up to whole units, piece by piece.
      const double slack = 15 * router.unit_metres();
      EXPECT_NEAR(route->cost, truth.cost, slack) << "trial " << trial;
      expect_sound(network, *route, start, goal, changes);
    }
  }
  EXPECT_GT(found, 400);
  EXPECT_GT(none, 80);
}

TEST(RoadRouter, FindsTheCheapestWayOnRandomRoads) {
  for (const auto search : {RouteSearch::kAStar, RouteSearch::kLandmarks, RouteSearch::kHierarchy})
    expect_cheapest_ways(search, false);
}

TEST(RoadRouter, GoesRoundWhatIsClosedCutOrDearer) {
  for (const auto search : {RouteSearch::kAStar, RouteSearch::kLandmarks, RouteSearch::kHierarchy})
    expect_cheapest_ways(search, true);
}

TEST(RoadRouter, DrivesUpToACutFromEitherSide) {
  RoadGraph graph;
  graph.nodes = {{1, 0, 0, 0}, {2, 10, 0, 0}};
  add_road(graph, 0, 1);
  const RoadNetwork network(graph, {});
  RoadRouter router(network);
  RoadChanges changes;
  changes.cut(0, 5);
  EXPECT_NEAR(router.find({0, 0}, {0, 4}, changes)->cost, 4, 1e-9);
  EXPECT_NEAR(router.find({0, 10}, {0, 6}, changes)->cost, 4, 1e-9);
  EXPECT_FALSE(router.find({0, 0}, {0, 6}, changes));
}

TEST(RoadSearch, CostsToAndFromAPlaceAgreeWithRoutes) {
  Random random(11);
  for (int trial = 0; trial < 50; ++trial) {
    const RoadGraph graph = random_roads(random, 8, 14);
    const RoadNetwork network(graph, {});
    RoadRouter router(network);
    const RoadPlace place{static_cast<std::uint32_t>(random.below(graph.edges.size())), 1.0};
    if (!network.usable(place.edge)) continue;
    const auto out = costs_from(network, place), into = costs_from(network, place, true);
    for (std::uint32_t node = 0; node < graph.nodes.size(); ++node) {
      const RoadPlace there = network.node_place(node);
      if (there.edge == graph.edges.size()) continue;
      const auto go = router.find(place, there), back = router.find(there, place);
      EXPECT_EQ(go.has_value(), std::isfinite(out[node]));
      EXPECT_EQ(back.has_value(), std::isfinite(into[node]));
      if (go) {
        EXPECT_NEAR(go->cost, out[node], 10 * router.unit_metres());
      }
      if (back) {
        EXPECT_NEAR(back->cost, into[node], 10 * router.unit_metres());
      }
    }
  }
}

TEST(RoadRouter, NarrowRoadsAreNotDriven) {
  RoadGraph graph;
  graph.nodes = {{1, 0, 0, 0}, {2, 10, 0, 0}};
  add_road(graph, 0, 1, {}, 2.0);
  add_road(graph, 0, 1, {Vector2(5, 20)}, 6.0);
  const auto edge_taken = [&](double min_clearance) {
    const RoadNetwork network(graph, {min_clearance, 0, 0});
    return RoadRouter(network).find({1, 0.0}, {1, network.length(1)})->legs.at(0).edge;
  };
  EXPECT_EQ(edge_taken(1.0), 0U);
  EXPECT_EQ(edge_taken(4.0), 1U);
}

}  // namespace
}  // namespace stope::planner
