#include <cmath>
#include <limits>
#include <optional>
#include <queue>
#include <tuple>

#include "plugins/source/synthetic_pit/curve.hpp"
#include "plugins/source/synthetic_pit/route.hpp"

namespace stope::source {
namespace {

constexpr double kSharpestTurn = 2.3;  // radians a truck turns at a junction

/// Legs as numbers, 2 * edge + backward.
class Search {
 public:
  explicit Search(const NetworkGraph& graph) : graph_(graph), leaving_(graph.nodes.size()) {
    for (std::size_t i = 0; i < graph.edges.size(); ++i) {
      length_.push_back(stations(graph.edges[i].points).back());
      leaving_[graph.edges[i].from].push_back(2 * i);
      leaving_[graph.edges[i].to].push_back(2 * i + 1);
    }
  }

  /// The legs that lead from the end of `last` over a nearest edge that is not `driven`.
  std::vector<std::size_t> to_new_edge(std::size_t last, const std::vector<bool>& driven) const {
    constexpr auto kNone = std::numeric_limits<std::size_t>::max();
    std::vector<double> cost(2 * graph_.edges.size(), std::numeric_limits<double>::infinity());
    std::vector<std::size_t> from(cost.size(), kNone);
    using Entry = std::tuple<double, std::size_t>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
    const auto push_next = [&](std::size_t leg, double reached) {
      for (const std::size_t next : leaving_[end_of(leg)]) {
        if (!may_follow(leg, next) || reached >= cost[next]) continue;
        cost[next] = reached;
        from[next] = leg;
        open.emplace(reached, next);
      }
    };
    push_next(last, 0);
    while (!open.empty()) {
      const auto [reached, leg] = open.top();
      open.pop();
      if (reached > cost[leg]) continue;
      if (!driven[leg / 2]) {
        std::vector<std::size_t> path{leg};
        for (std::size_t step = from[leg]; step != last && step != kNone; step = from[step])
          path.insert(path.begin(), step);
        return path;
      }
      push_next(leg, reached + length_[leg / 2]);
    }
    return {};
  }

 private:
  std::size_t end_of(std::size_t leg) const {
    const auto& edge = graph_.edges[leg / 2];
    return leg % 2 == 0 ? edge.to : edge.from;
  }

  Vector2 direction(std::size_t leg, bool at_end) const {
    const auto& points = graph_.edges[leg / 2].points;
    const std::size_t reach = std::min<std::size_t>(4, points.size() - 1);
    const bool tail = at_end == (leg % 2 == 0);
    const Vector2 along = tail ? Vector2(points.back() - points[points.size() - 1 - reach])
                               : Vector2(points[reach] - points.front());
    return (leg % 2 == 0 ? 1.0 : -1.0) * along.normalized();
  }

  bool may_follow(std::size_t leg, std::size_t next) const {
    if ((leg ^ next) == 1) return graph_.nodes[end_of(leg)].dead_end.has_value();
    return direction(leg, true).dot(direction(next, false)) > std::cos(kSharpestTurn);
  }

  const NetworkGraph& graph_;
  std::vector<double> length_;
  std::vector<std::vector<std::size_t>> leaving_;
};

}  // namespace

std::vector<Leg> covering_route(const NetworkGraph& graph, const Checkpoint& checkpoint) {
  const Search search(graph);
  std::size_t first = 0;
  for (std::size_t i = 0; i < graph.edges.size(); ++i) {
    if (graph.nodes[graph.edges[i].from].dead_end) first = 2 * i;
    if (graph.nodes[graph.edges[i].to].dead_end) first = 2 * i + 1;
  }
  std::vector<bool> driven(graph.edges.size(), false);
  std::vector<Leg> legs;
  std::vector<std::size_t> path{first};
  while (!path.empty()) {
    checkpoint();
    for (const std::size_t leg : path) {
      driven[leg / 2] = true;
      legs.push_back({leg / 2, leg % 2 == 1});
    }
    path = search.to_new_edge(path.back(), driven);
  }
  // Into the first turning place and out of the last, so that the truck sees all of them from
  // inside.
  const auto node = [&](const Leg& leg, bool at_end) {
    const auto& edge = graph.edges[leg.edge];
    return graph.nodes[leg.backward == at_end ? edge.from : edge.to];
  };
  const auto back = [](const Leg& leg) { return Leg{leg.edge, !leg.backward}; };
  if (node(legs.front(), false).dead_end) legs.insert(legs.begin(), back(legs.front()));
  if (node(legs.back(), true).dead_end) legs.push_back(back(legs.back()));
  return legs;
}

}  // namespace stope::source
