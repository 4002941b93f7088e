// Cheapest ways on graphs of a million nodes, beside plain Dijkstra and Boost.Graph's A* on the
// same queries in the same run.
//
//   taskset -c 0 build/bin/routing_benchmark [--side N] [--queries N] [--truth N]
//   [lattice|uneven|roads …]
//
// Networks: `lattice` of 1000 x 1000 nodes, all pieces 10 m; `uneven`, the same with costs between
// 1 and 2 times the length at random; `roads`, the road-like network of test_networks.cpp. Pairs of
// nodes are uniform and random. For the reroute the piece in the middle of each pair's cheapest way
// is blocked both ways. Times are the thread's own CPU time, for each query apart.
#include <fmt/format.h>
#include <time.h>

#include <algorithm>
#include <boost/graph/astar_search.hpp>
#include <boost/graph/compressed_sparse_row_graph.hpp>
#include <cmath>
#include <cstring>
#include <optional>
#include <string>

#include "plugins/planner/dijkstra_search.hpp"
#include "plugins/planner/hierarchy_search.hpp"
#include "plugins/planner/landmark_search.hpp"
#include "plugins/planner/reroute_search.hpp"
#include "stope/random.hpp"
#include "tests/benchmarks/routing/test_networks.hpp"

namespace stope::planner {
namespace {

struct Options {
  std::uint32_t side = 0;
  std::size_t queries = 1000;  // timed
  std::size_t truth = 10'000;  // compared with Dijkstra's
};

double now_ms() {
  timespec time{};
  ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

class Times {
 public:
  template <class Work>
  auto of(Work&& work) {
    const double start = now_ms();
    auto result = work();
    times_.push_back(now_ms() - start);
    return result;
  }
  void print(const char* name, double settled) {
    std::sort(times_.begin(), times_.end());
    fmt::print("  {:<44} median {:8.3f} ms, p99 {:8.3f} ms, {:.0f} nodes settled, {} queries\n",
               name, times_[times_.size() / 2], times_[times_.size() * 99 / 100], settled,
               times_.size());
    std::fflush(stdout);
  }

 private:
  std::vector<double> times_;
};

struct Pair {
  WayEnd source, target;
};

std::vector<Pair> random_pairs(const SearchGraph& graph, std::size_t count) {
  Random random(7);
  std::vector<Pair> pairs(count);
  for (Pair& pair : pairs) {
    pair.source.node = static_cast<std::uint32_t>(random.below(graph.node_count()));
    pair.target.node = static_cast<std::uint32_t>(random.below(graph.node_count()));
  }
  return pairs;
}

template <class Find>
void measure(const char* name, const std::vector<Pair>& pairs, std::size_t count,
             const Find& find) {
  Times times;
  double settled = 0;
  count = std::min(count, pairs.size());
  for (std::size_t i = 0; i < count; ++i)
    settled += static_cast<double>(times.of([&] { return find(pairs[i], i); }).settled);
  times.print(name, settled / static_cast<double>(count));
}

/// Boost.Graph's A* on a CSR graph, with the straight line as its lower bound.
class BoostSearch {
 public:
  BoostSearch(const TestNetwork& network, double cost_per_metre)
      : network_(network), cost_per_metre_(cost_per_metre) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> ends;
    std::vector<std::uint32_t> costs;
    for (const ArcBetween& arc : network.arcs) {
      ends.emplace_back(arc.from, arc.to);
      costs.push_back(arc.cost);
    }
    graph_.emplace(boost::edges_are_unsorted_multi_pass, ends.begin(), ends.end(), costs.begin(),
                   network.x.size());
  }
  Way find(const Pair& pair) {
    Way way;
    const auto count = network_.x.size();
    std::vector<WayCost> distances(count);
    std::vector<std::uint32_t> before(count);
    struct Arrived {};
    struct Stop : boost::default_astar_visitor {
      std::uint32_t goal = 0;
      std::uint32_t* settled = nullptr;
      void examine_vertex(std::uint32_t node, const Csr&) const {
        ++*settled;
        if (node == goal) throw Arrived{};
      }
    } stop;
    stop.goal = pair.target.node;
    stop.settled = &way.settled;
    const double goal_x = network_.x[stop.goal], goal_y = network_.y[stop.goal];
    try {
      boost::astar_search(
          *graph_, pair.source.node,
          [&](std::uint32_t node) {
            return static_cast<WayCost>(
                cost_per_metre_ * std::hypot(network_.x[node] - goal_x, network_.y[node] - goal_y));
          },
          boost::visitor(stop)
              .weight_map(boost::get(boost::edge_bundle, *graph_))
              .distance_map(boost::make_iterator_property_map(
                  distances.begin(), boost::get(boost::vertex_index, *graph_)))
              .predecessor_map(boost::make_iterator_property_map(
                  before.begin(), boost::get(boost::vertex_index, *graph_)))
              .distance_inf(kNoWay));
    } catch (const Arrived&) {
      way.cost = distances[stop.goal];
    }
    return way;
  }

 private:
  using Csr = boost::compressed_sparse_row_graph<boost::directedS, boost::no_property,
                                                 std::uint32_t, boost::no_property, std::uint32_t>;
  const TestNetwork& network_;
  double cost_per_metre_;
  std::optional<Csr> graph_;
};

/// Whether a way's arcs join its ends and cost what it says.
bool whole(const SearchGraph& graph, const Pair& pair, const CostChanges& changes, const Way& way) {
  if (!way.found()) return true;
  WayCost cost = 0;
  std::uint32_t node = pair.source.node;
  for (const std::uint32_t arc : way.arcs) {
    if (graph.source(arc) != node) return false;
    cost += changes.cost(arc, graph.arc(arc).cost);
    node = graph.arc(arc).to;
  }
  return node == pair.target.node && cost == way.cost;
}

/// The piece in the middle of a way, both ways.
CostChanges block_middle(const SearchGraph& graph, const Way& way) {
  CostChanges changes;
  if (way.arcs.empty()) return changes;
  const std::uint32_t arc = way.arcs[way.arcs.size() / 2];
  changes.block(arc);
  for (const SearchGraph::Into& into : graph.into(graph.source(arc)))
    if (into.from == graph.arc(arc).to) changes.block(into.arc);
  return changes;
}

void compare(const SearchGraph& graph, const std::vector<Pair>& pairs, HierarchySearch& hierarchy,
             LandmarkSearch& landmarks, RerouteSearch& reroute) {
  DijkstraSearch dijkstra(graph);
  Random random(11);
  std::size_t wrong = 0, compared = 0;
  // All queries from one node at once would be one search; each has a random source instead, and
  // several targets share it, so that the truth is affordable.
  constexpr std::size_t kShared = 50;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    static std::vector<WayCost> truth;
    const std::uint32_t source = pairs[i / kShared * kShared].source.node;
    if (i % kShared == 0) truth = dijkstra.costs(source);
    const Pair pair{{source, 0}, pairs[i].target};
    const CostChanges none;
    for (const Way& way : {hierarchy.find({&pair.source, 1}, {&pair.target, 1}),
                           reroute.find({&pair.source, 1}, {&pair.target, 1}, none)}) {
      ++compared;
      wrong += way.cost != truth[pair.target.node] || !whole(graph, pair, none, way);
    }
    if (i % 10 == 0) {
      const Way way = landmarks.find({&pair.source, 1}, {&pair.target, 1});
      ++compared;
      wrong += way.cost != truth[pair.target.node] || !whole(graph, pair, none, way);
    }
    if (i % 50 != 0) continue;
    // A blocked piece on the way and a hundred dearer ones anywhere.
    CostChanges changes = block_middle(graph, hierarchy.find({&pair.source, 1}, {&pair.target, 1}));
    for (int k = 0; k < 100; ++k) {
      const auto arc = static_cast<std::uint32_t>(random.below(graph.arc_count()));
      changes.raise(arc, graph.arc(arc).cost * (2 + random.below(10)));
    }
    const WayCost changed = dijkstra.find({&pair.source, 1}, {&pair.target, 1}, changes).cost;
    for (const Way& way : {reroute.find({&pair.source, 1}, {&pair.target, 1}, changes),
                           landmarks.find({&pair.source, 1}, {&pair.target, 1}, changes)}) {
      ++compared;
      wrong += way.cost != changed || !whole(graph, pair, changes, way);
    }
  }
  fmt::print("  {} of {} ways compared with Dijkstra's are not optimal or not whole\n", wrong,
             compared);
}

void run(const std::string& name, const TestNetwork& network, double cost_per_metre,
         const Options& options) {
  const SearchGraph graph = network.graph();
  fmt::print("{}: {} nodes, {} arcs\n", name, graph.node_count(), graph.arc_count());
  std::fflush(stdout);
  double start = now_ms();
  const ContractionHierarchy hierarchy(graph, network.places());
  fmt::print("  contraction hierarchy made in {:.1f} s, {} arcs and shortcuts\n",
             1e-3 * (now_ms() - start), hierarchy.up().arcs.size() + hierarchy.down().arcs.size());
  start = now_ms();
  const Landmarks landmarks(graph, 16);
  fmt::print("  16 landmarks measured in {:.1f} s\n", 1e-3 * (now_ms() - start));
  const auto pairs = random_pairs(graph, std::max(options.truth, options.queries));

  HierarchySearch hierarchy_search(hierarchy);
  RerouteSearch reroute_search(graph, hierarchy);
  LandmarkSearch landmark_search(graph, landmarks);
  DijkstraSearch dijkstra(graph);
  BoostSearch boost(network, cost_per_metre);
  measure("contraction hierarchy, the whole way", pairs, options.queries,
          [&](const Pair& pair, std::size_t) {
            return hierarchy_search.find({&pair.source, 1}, {&pair.target, 1});
          });
  std::vector<CostChanges> blocked;
  for (std::size_t i = 0; i < options.queries; ++i)
    blocked.push_back(
        block_middle(graph, hierarchy_search.find({&pairs[i].source, 1}, {&pairs[i].target, 1})));
  measure("rerouted round a newly blocked piece", pairs, options.queries,
          [&](const Pair& pair, std::size_t i) {
            return reroute_search.find({&pair.source, 1}, {&pair.target, 1}, blocked[i]);
          });
  const std::size_t slow = std::max<std::size_t>(1, options.queries / 20);
  measure("landmarks, both ends", pairs, 4 * slow, [&](const Pair& pair, std::size_t) {
    return landmark_search.find({&pair.source, 1}, {&pair.target, 1});
  });
  measure("landmarks, a piece blocked", pairs, 4 * slow, [&](const Pair& pair, std::size_t i) {
    return landmark_search.find({&pair.source, 1}, {&pair.target, 1}, blocked[i]);
  });
  measure("plain Dijkstra", pairs, slow, [&](const Pair& pair, std::size_t) {
    return dijkstra.find({&pair.source, 1}, {&pair.target, 1});
  });
  measure("Boost.Graph astar_search", pairs, slow,
          [&](const Pair& pair, std::size_t) { return boost.find(pair); });
  if (options.truth > 0)
    compare(graph, {pairs.begin(), pairs.begin() + static_cast<std::ptrdiff_t>(options.truth)},
            hierarchy_search, landmark_search, reroute_search);
}

}  // namespace
}  // namespace stope::planner

int main(int argc, char** argv) {
  using namespace stope::planner;
  Options options;
  std::vector<std::string> chosen;
  for (int i = 1; i < argc; ++i) {
    if (!std::strcmp(argv[i], "--side") && i + 1 < argc)
      options.side = static_cast<std::uint32_t>(std::atoi(argv[++i]));
    else if (!std::strcmp(argv[i], "--queries") && i + 1 < argc)
      options.queries = static_cast<std::size_t>(std::atoi(argv[++i]));
    else if (!std::strcmp(argv[i], "--truth") && i + 1 < argc)
      options.truth = static_cast<std::size_t>(std::atoi(argv[++i]));
    else
      chosen.emplace_back(argv[i]);
  }
  if (chosen.empty()) chosen = {"lattice", "uneven", "roads"};
  const std::uint32_t side = options.side > 0 ? options.side : 1000;
  for (const std::string& name : chosen) {
    if (name == "lattice")
      run("Lattice", lattice(side, 1, 1), 1000, options);
    else if (name == "uneven")
      run("Uneven lattice", lattice(side, 2, 1), 1000, options);
    else if (name == "roads")
      run("Roads", road_like(options.side > 0 ? side / 2 : 512, 1), 1e4 / (100 / 3.6), options);
  }
}
