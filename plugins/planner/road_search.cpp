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
std::array<EdgeEnd, 2> ends_of(const RoadNetwork& network, RoadPlace place, bool towards,
                               const RoadChanges& changes) {
  const RoadEdge& edge = network.graph().edges[place.edge];
  const double length = network.length(place.edge);
  std::array<EdgeEnd, 2> ends{EdgeEnd{edge.from, 0, kInfinity},
                              EdgeEnd{edge.to, length, kInfinity}};
  const bool to_from = towards ? network.forward(place.edge) : network.backward(place.edge);
  const bool to_to = towards ? network.backward(place.edge) : network.forward(place.edge);
  const double factor = changes.factor(place.edge);
  if (place.along <= kAtNode)
    ends[0].cost = 0;
  else if (to_from && !changes.blocked(place.edge, 0, place.along))
    ends[0].cost = factor * network.cost(place.edge, place.along, 0);
  if (place.along >= length - kAtNode)
    ends[1].cost = 0;
  else if (to_to && !changes.blocked(place.edge, place.along, length))
    ends[1].cost = factor * network.cost(place.edge, place.along, length);
  return ends;
}

}  // namespace

std::vector<double> costs_from(const RoadNetwork& network, RoadPlace start, bool against,
                               const RoadChanges& changes) {
  std::vector<double> costs(network.graph().nodes.size(), kInfinity);
  Heap heap;
  for (const EdgeEnd& end : ends_of(network, start, against, changes)) {
    if (end.cost >= costs[end.node]) continue;
    costs[end.node] = end.cost;
    heap.push({end.cost, end.node});
  }
  while (!heap.empty()) {
    const Entry top = heap.top();
    heap.pop();
    if (top.estimate > costs[top.node]) continue;
    for (const Arc& arc : against ? network.arcs_into(top.node) : network.arcs_from(top.node)) {
      if (changes.blocked(arc.edge, 0, network.length(arc.edge))) continue;
      const double cost = top.estimate + changes.factor(arc.edge) * arc.cost;
      if (cost >= costs[arc.to]) continue;
      costs[arc.to] = cost;
      heap.push({costs[arc.to], arc.to});
    }
  }
  return costs;
}

}  // namespace stope::planner
