// Problem: the cheapest way between two places that lie anywhere along the roads.
// Idea: A* over the nodes (Hart, Nilsson and Raphael 1968). The start's edge gives the first nodes,
// with the cost of the piece of edge up to them; the goal's edge gives the last, and a way within
// one edge is a candidate from the outset. The straight line to the goal never overestimates, since
// a metre costs at least one.
// Cost: O(E log V) at worst; the heap holds stale entries instead of decreasing keys.
#include "plugins/planner/road_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <queue>
#include <tuple>

namespace stope::planner {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kAtNode = 1e-9;  // metres
constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

struct Entry {
  double estimate;
  std::uint32_t node;
  bool operator>(const Entry& other) const {
    return std::tie(estimate, node) > std::tie(other.estimate, other.node);
  }
};
using Heap = std::priority_queue<Entry, std::vector<Entry>, std::greater<>>;

/// A node next to a place on an edge, and the piece of edge between them.
struct EdgeEnd {
  std::uint32_t node = kNone;
  double along = 0;  // of the node on the edge
  double cost = kInfinity;
};

/// The ends of a place's edge, with what it costs to drive from the place to them, or with
/// `towards` from them to the place.
std::array<EdgeEnd, 2> ends_of(const RoadNetwork& network, RoadPlace place, bool towards) {
  const RoadEdge& edge = network.graph().edges[place.edge];
  const double length = network.length(place.edge);
  std::array<EdgeEnd, 2> ends{EdgeEnd{edge.from, 0, kInfinity},
                              EdgeEnd{edge.to, length, kInfinity}};
  const bool to_from = towards ? network.forward(place.edge) : network.backward(place.edge);
  const bool to_to = towards ? network.backward(place.edge) : network.forward(place.edge);
  if (to_from || place.along <= kAtNode) ends[0].cost = network.cost(place.edge, place.along, 0);
  if (to_to || place.along >= length - kAtNode)
    ends[1].cost = network.cost(place.edge, place.along, length);
  return ends;
}

struct Reached {
  double cost = kInfinity;
  std::uint32_t edge = kNone;      // the one it was reached by
  std::uint32_t previous = kNone;  // node; none: straight from the start
};

Route trace(const RoadNetwork& network, const std::vector<Reached>& reached, RoadPlace start,
            RoadPlace goal, const EdgeEnd& entry, double cost) {
  Route route;
  route.cost = cost;
  route.legs.push_back({goal.edge, entry.along, goal.along});
  std::uint32_t node = entry.node;
  while (reached[node].previous != kNone) {
    const RoadEdge& edge = network.graph().edges[reached[node].edge];
    const double length = network.length(reached[node].edge);
    const bool with = edge.to == node && edge.from == reached[node].previous &&
                      (edge.from != edge.to || network.forward(reached[node].edge));
    route.legs.push_back({reached[node].edge, with ? 0 : length, with ? length : 0});
    node = reached[node].previous;
  }
  const RoadEdge& first = network.graph().edges[start.edge];
  const auto ends = ends_of(network, start, false);
  const bool at_first = first.from == node && (first.to != node || ends[0].cost <= ends[1].cost);
  route.legs.push_back({start.edge, start.along, at_first ? 0 : network.length(start.edge)});
  std::reverse(route.legs.begin(), route.legs.end());
  std::erase_if(route.legs, [](const RouteLeg& leg) { return leg.from == leg.to; });
  if (route.legs.empty()) route.legs.push_back({goal.edge, goal.along, goal.along});
  return route;
}

}  // namespace

std::optional<Route> find_route(const RoadNetwork& network, RoadPlace start, RoadPlace goal) {
  const auto& nodes = network.graph().nodes;
  const RoadVertex target = network.at(goal);
  const auto estimate = [&](std::uint32_t node) {
    return std::hypot(nodes[node].x - target.x, nodes[node].y - target.y);
  };

  double best = kInfinity;
  std::optional<EdgeEnd> best_entry;  // none: within one edge
  if (start.edge == goal.edge) {
    const bool onward = goal.along >= start.along;
    if (start.along == goal.along ||
        (onward ? network.forward(start.edge) : network.backward(start.edge)))
      best = network.cost(start.edge, start.along, goal.along);
  }

  std::vector<Reached> reached(nodes.size());
  Heap heap;
  for (const EdgeEnd& end : ends_of(network, start, false)) {
    if (end.cost >= reached[end.node].cost) continue;
    reached[end.node] = {end.cost, start.edge, kNone};
    heap.push({end.cost + estimate(end.node), end.node});
  }
  const auto entries = ends_of(network, goal, true);
  while (!heap.empty()) {
    const Entry top = heap.top();
    heap.pop();
    if (top.estimate >= best) break;
    const double cost = reached[top.node].cost;
    if (top.estimate > cost + estimate(top.node)) continue;  // stale
    for (const EdgeEnd& entry : entries) {
      if (entry.node == top.node && cost + entry.cost < best) {
        best = cost + entry.cost;
        best_entry = entry;
      }
    }
    for (const Arc& arc : network.arcs_from(top.node)) {
      if (cost + arc.cost >= reached[arc.to].cost) continue;
      reached[arc.to] = {cost + arc.cost, arc.edge, top.node};
      heap.push({cost + arc.cost + estimate(arc.to), arc.to});
    }
  }
  if (best == kInfinity) return std::nullopt;
  if (!best_entry) return Route{{{start.edge, start.along, goal.along}}, best};
  return trace(network, reached, start, goal, *best_entry, best);
}

std::vector<double> costs_from(const RoadNetwork& network, RoadPlace start, bool against) {
  std::vector<double> costs(network.graph().nodes.size(), kInfinity);
  Heap heap;
  for (const EdgeEnd& end : ends_of(network, start, against)) {
    if (end.cost >= costs[end.node]) continue;
    costs[end.node] = end.cost;
    heap.push({end.cost, end.node});
  }
  while (!heap.empty()) {
    const Entry top = heap.top();
    heap.pop();
    if (top.estimate > costs[top.node]) continue;
    for (const Arc& arc : against ? network.arcs_into(top.node) : network.arcs_from(top.node)) {
      if (top.estimate + arc.cost >= costs[arc.to]) continue;
      costs[arc.to] = top.estimate + arc.cost;
      heap.push({costs[arc.to], arc.to});
    }
  }
  return costs;
}

}  // namespace stope::planner
