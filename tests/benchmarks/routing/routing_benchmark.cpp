// Cheapest ways on graphs of a million nodes, beside plain Dijkstra and Boost.Graph's A* on the
// same queries in the same run.
//
//   build/bin/routing_benchmark [--side N] [--queries N] [--truth N] [lattice|uneven|roads …]
//   build/bin/routing_benchmark --queries 0            only compares, 10 000 pairs a network
//
// Networks: `lattice` of 1000 x 1000 nodes, all pieces 10 m; `uneven`, the same with costs between
// 1 and 2 times the length at random; `roads`, the road-like network of test_networks.cpp. Pairs of
// nodes are uniform and random. For the reroute the piece in the middle of each pair's cheapest way
// is blocked both ways. Times are the thread's own CPU time, for each query apart; those of
// preparing also by the clock on the wall. `--truth N` compares N pairs with Dijkstra's search, as
// they are and with roads blocked and dearer.
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

double now_ms(clockid_t clock = CLOCK_THREAD_CPUTIME_ID) {
  timespec time{};
  ::clock_gettime(clock, &time);
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
  if (count == 0) return;
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

/// Blocks the piece in the middle of a way, both ways.
void block_middle(const SearchGraph& graph, const Way& way, CostChanges& changes) {
  if (way.arcs.empty()) return;
  const std::uint32_t arc = way.arcs[way.arcs.size() / 2];
  changes.block(arc);
  for (const SearchGraph::Into& into : graph.into(graph.source(arc)))
    if (into.from == graph.arc(arc).to) changes.block(into.arc);
}

/// Compares with Dijkstra's search on the whole graph: every 20 pairs share their first source, so
/// that one search is the truth for 20. Then the same pairs with the pieces in the middle of five
/// of their ways blocked both ways, and a hundred pieces anywhere 2 to 11 times as dear.
void compare(const SearchGraph& graph, std::vector<Pair> pairs, HierarchySearch& hierarchy,
             LandmarkSearch& landmarks, RerouteSearch& reroute) {
  constexpr std::size_t kShared = 20, kBlocked = 5, kRaised = 100;
  DijkstraSearch dijkstra(graph);
  Random random(11);
  struct Count {
    const char* name;
    std::size_t compared = 0, wrong = 0, detours = 0;
  } counts[] = {{"contraction hierarchy"},
                {"rerouting, nothing changed"},
                {"landmarks"},
                {"rerouting, roads blocked and dearer"},
                {"landmarks, roads blocked and dearer"}};
  for (std::size_t i = 0; i < pairs.size(); i += kShared) {
    const std::span<Pair> group = std::span(pairs).subspan(i, std::min(kShared, pairs.size() - i));
    for (Pair& pair : group) pair.source = group.front().source;
    const CostChanges none;
    CostChanges changes;
    const auto unchanged = dijkstra.costs(group.front().source.node);
    const auto check = [&](Count& count, const Pair& pair, const std::vector<WayCost>& truth,
                           const CostChanges& now, const Way& way) {
      ++count.compared;
      count.wrong += way.cost != truth[pair.target.node] || !whole(graph, pair, now, way);
      count.detours += truth[pair.target.node] != unchanged[pair.target.node];
    };
    for (std::size_t k = 0; k < group.size(); ++k) {
      const std::span<const WayEnd> from(&group[k].source, 1), to(&group[k].target, 1);
      const Way way = hierarchy.find(from, to);
      check(counts[0], group[k], unchanged, none, way);
      check(counts[1], group[k], unchanged, none, reroute.find(from, to, none));
      if (k == 0) check(counts[2], group[k], unchanged, none, landmarks.find(from, to));
      if (k < kBlocked) block_middle(graph, way, changes);
    }
    for (std::size_t k = 0; k < kRaised; ++k) {
      const auto arc = static_cast<std::uint32_t>(random.below(graph.arc_count()));
      changes.raise(arc, graph.arc(arc).cost * (2 + random.below(10)));
    }
    const auto changed = dijkstra.costs(group.front().source.node, false, changes);
    for (std::size_t k = 0; k < group.size(); ++k) {
      const std::span<const WayEnd> from(&group[k].source, 1), to(&group[k].target, 1);
      check(counts[3], group[k], changed, changes, reroute.find(from, to, changes));
      if (k == 0) check(counts[4], group[k], changed, changes, landmarks.find(from, to, changes));
    }
  }
  for (const Count& count : counts)
    fmt::print("  {:<44} {} of {} ways are not Dijkstra's or not whole; {} lead round\n",
               count.name, count.wrong, count.compared, count.detours);
  std::fflush(stdout);
}

void run(const std::string& name, const TestNetwork& network, double cost_per_metre,
         const Options& options) {
  const SearchGraph graph = network.graph();
  fmt::print("{}: {} nodes, {} arcs\n", name, graph.node_count(), graph.arc_count());
  std::fflush(stdout);
  // On all threads that oneTBB has.
  const double wall = now_ms(CLOCK_MONOTONIC), processor = now_ms(CLOCK_PROCESS_CPUTIME_ID);
  const ContractionHierarchy hierarchy(graph, network.places());
  fmt::print(
      "  contraction hierarchy made in {:.1f} s ({:.1f} s of processor time), {} arcs and "
      "shortcuts\n",
      1e-3 * (now_ms(CLOCK_MONOTONIC) - wall),
      1e-3 * (now_ms(CLOCK_PROCESS_CPUTIME_ID) - processor),
      hierarchy.up().arcs.size() + hierarchy.down().arcs.size());
  std::fflush(stdout);
  const double start = now_ms();
  const Landmarks landmarks(graph, 16);
  fmt::print("  16 landmarks measured in {:.1f} s\n", 1e-3 * (now_ms() - start));
  const auto pairs = random_pairs(graph, std::max(options.truth, options.queries));

  const double sweep = now_ms();
  const auto by_rank = landmarks_by_rank(hierarchy);
  if (by_rank) fmt::print("  16 more for its corridors in {:.1f} s\n", 1e-3 * (now_ms() - sweep));
  HierarchySearch hierarchy_search(hierarchy, by_rank ? &*by_rank : nullptr);
  RerouteSearch reroute_search(graph, hierarchy, by_rank ? &*by_rank : nullptr);
  LandmarkSearch landmark_search(graph, landmarks);
  DijkstraSearch dijkstra(graph);
  BoostSearch boost(network, cost_per_metre);
  measure("contraction hierarchy, the whole way", pairs, options.queries,
          [&](const Pair& pair, std::size_t) {
            return hierarchy_search.find({&pair.source, 1}, {&pair.target, 1});
          });
  std::vector<CostChanges> blocked(options.queries);
  for (std::size_t i = 0; i < options.queries; ++i)
    block_middle(graph, hierarchy_search.find({&pairs[i].source, 1}, {&pairs[i].target, 1}),
                 blocked[i]);
  measure("rerouted round a newly blocked piece", pairs, options.queries,
          [&](const Pair& pair, std::size_t i) {
            return reroute_search.find({&pair.source, 1}, {&pair.target, 1}, blocked[i]);
          });
  const std::size_t slow = (options.queries + 19) / 20;
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
