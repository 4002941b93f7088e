// Problem: the cheapest way between two places that lie anywhere along the roads.
// Idea: the start's edge gives the first nodes, with the cost of the piece of edge up to them; the
// goal's edge gives the last. Between them a search over nodes and whole edges finds the way; a way
// within one edge is a candidate from the outset.
// Cost: that of the search, see RouteSearch, and O(changes) for what is blocked or dearer.
#include "plugins/planner/road_router.hpp"

#include <algorithm>
#include <cmath>

#include "plugins/planner/best_first_search.hpp"
#include "plugins/planner/hierarchy_search.hpp"
#include "plugins/planner/landmark_search.hpp"
#include "plugins/planner/reroute_search.hpp"

namespace stope::planner {
namespace {

constexpr double kAtNode = 1e-9;  // metres
constexpr std::uint32_t kLandmarks = 16;

/// Units a metre: fine enough to tell ways apart, coarse enough for 32 bits to hold the longest.
double units_for(double all_roads) {
  double units = 65536;
  while (units > 1024 && all_roads * units > 1e9) units /= 2;
  return units;
}

}  // namespace

struct RoadRouter::Searches {
  std::optional<BestFirstSearch> plain;
  std::optional<Landmarks> landmarks;
  std::optional<LandmarkSearch> by_landmarks;
  std::optional<ContractionHierarchy> hierarchy;
  std::optional<Landmarks> landmarks_by_rank;
  std::optional<HierarchySearch> by_hierarchy;
  std::optional<RerouteSearch> reroute;
};

RoadRouter::RoadRouter(const RoadNetwork& network, RouteSearch search,
                       const std::function<void()>& pause)
    : network_(network), searches_(std::make_unique<Searches>()) {
  const auto& edges = network.graph().edges;
  double all = 0;
  for (std::uint32_t e = 0; e < edges.size(); ++e)
    if (network.usable(e)) all += network.cost(e, 0, network.length(e));
  units_ = units_for(all);
  std::vector<ArcBetween> given;
  for (std::uint32_t e = 0; e < edges.size(); ++e) {
    first_.push_back(static_cast<std::uint32_t>(given.size()));
    if (!network.usable(e)) continue;
    const auto cost = static_cast<std::uint32_t>(
        std::min<WayCost>(in_units(network.cost(e, 0, network.length(e))), kNoArc - 1));
    if (network.forward(e)) given.push_back({edges[e].from, edges[e].to, cost});
    if (network.backward(e)) given.push_back({edges[e].to, edges[e].from, cost});
    edges_.resize(given.size(), e);
  }
  first_.push_back(static_cast<std::uint32_t>(given.size()));
  graph_ = SearchGraph(static_cast<std::uint32_t>(network.graph().nodes.size()), given);
  arcs_.resize(graph_.arc_count());
  for (std::uint32_t arc = 0; arc < arcs_.size(); ++arc) arcs_[graph_.given(arc)] = arc;
  if (search == RouteSearch::kLandmarks) {
    searches_->landmarks.emplace(graph_, kLandmarks, pause);
    searches_->by_landmarks.emplace(graph_, *searches_->landmarks);
  } else if (search == RouteSearch::kHierarchy) {
    std::vector<NodePlace> places;
    for (const RoadNode& node : network.graph().nodes)
      places.push_back({static_cast<float>(node.x), static_cast<float>(node.y)});
    searches_->hierarchy.emplace(graph_, places, pause);
    searches_->landmarks_by_rank = landmarks_by_rank(*searches_->hierarchy, pause);
    const Landmarks* by_rank =
        searches_->landmarks_by_rank ? &*searches_->landmarks_by_rank : nullptr;
    searches_->by_hierarchy.emplace(*searches_->hierarchy, by_rank);
    searches_->reroute.emplace(graph_, *searches_->hierarchy, by_rank);
  } else {
    searches_->plain.emplace(graph_);
  }
}

RoadRouter::~RoadRouter() = default;

WayCost RoadRouter::in_units(double cost) const {
  return static_cast<WayCost>(std::ceil(std::min(cost * units_, 1e15)));
}

/// The nodes next to a place, with what it costs to drive to them from it, or to it from them.
std::vector<WayEnd> RoadRouter::ends_of(RoadPlace place, Side side,
                                        const RoadChanges& changes) const {
  const RoadEdge& edge = network_.graph().edges[place.edge];
  const double length = network_.length(place.edge);
  const bool forward = network_.forward(place.edge), backward = network_.backward(place.edge);
  const double factor = changes.factor(place.edge);
  std::vector<WayEnd> ends;
  const auto add = [&](std::uint32_t node, double node_along, bool direction) {
    const bool there = std::abs(place.along - node_along) <= kAtNode;
    if (there)
      ends.push_back({node, 0});
    else if (direction && !changes.blocked(place.edge, place.along, node_along))
      ends.push_back({node, in_units(factor * network_.cost(place.edge, place.along, node_along))});
  };
  add(edge.from, 0, side == Side::kFrom ? backward : forward);
  add(edge.to, length, side == Side::kFrom ? forward : backward);
  return ends;
}

bool RoadRouter::drivable(RoadPlace from, RoadPlace to, const RoadChanges& changes) const {
  if (from.edge != to.edge) return false;
  if (from.along == to.along) return true;
  return !changes.blocked(from.edge, from.along, to.along) &&
         (from.along < to.along ? network_.forward(from.edge) : network_.backward(from.edge));
}

Way RoadRouter::search(RoadPlace goal, const std::vector<WayEnd>& sources,
                       const std::vector<WayEnd>& targets, const CostChanges& changes) {
  if (searches_->by_landmarks) return searches_->by_landmarks->find(sources, targets, changes);
  if (searches_->by_hierarchy)
    return changes.empty() ? searches_->by_hierarchy->find(sources, targets)
                           : searches_->reroute->find(sources, targets, changes);
  const RoadVertex there = network_.at(goal);
  const auto& nodes = network_.graph().nodes;
  // A metre costs a metre at least, and costs are rounded up, this is rounded down.
  return searches_->plain->find(sources, targets, changes, [&](std::uint32_t node) {
    return static_cast<WayCost>((1 - 1e-12) * units_ *
                                std::hypot(nodes[node].x - there.x, nodes[node].y - there.y));
  });
}

std::optional<Route> RoadRouter::find(RoadPlace start, RoadPlace goal, const RoadChanges& changes) {
  CostChanges arcs;
  for (const auto& [edge, change] : changes.all()) {
    for (std::uint32_t i = first_[edge]; i < first_[edge + 1]; ++i) {
      if (change.passable())
        arcs.raise(arcs_[i],
                   in_units(change.factor * network_.cost(edge, 0, network_.length(edge))));
      else
        arcs.block(arcs_[i]);
    }
  }
  const auto sources = ends_of(start, Side::kFrom, changes);
  const auto targets = ends_of(goal, Side::kTowards, changes);
  const Way way = search(goal, sources, targets, arcs);
  const auto cost_of = [&](const RouteLeg& leg) {
    return leg.from == leg.to
               ? 0.0
               : changes.factor(leg.edge) * network_.cost(leg.edge, leg.from, leg.to);
  };
  const RouteLeg within{start.edge, start.along, goal.along};
  Route route;
  if (drivable(start, goal, changes) && in_units(cost_of(within)) <= way.cost) {
    route.legs = {within};
  } else if (!way.found()) {
    return std::nullopt;
  } else {
    // Where an edge is a ring its node is at both ends: the end that costs what the search was
    // told.
    const auto leg_end = [&](RoadPlace place, std::uint32_t node, const std::vector<WayEnd>& ends) {
      const RoadEdge& edge = network_.graph().edges[place.edge];
      WayCost least = kNoWay;
      for (const WayEnd& end : ends)
        if (end.node == node) least = std::min(least, end.cost);
      const double length = network_.length(place.edge);
      const auto costs_least = [&](double end) {
        return std::abs(place.along - end) <= kAtNode
                   ? least == 0
                   : in_units(cost_of({place.edge, place.along, end})) == least;
      };
      if (edge.from != edge.to) return edge.from == node ? 0.0 : length;
      const bool may_start =
          &ends == &sources ? network_.backward(place.edge) : network_.forward(place.edge);
      return costs_least(0) && (may_start || place.along <= kAtNode) ? 0.0 : length;
    };
    route.legs.push_back({start.edge, start.along, leg_end(start, way.source, sources)});
    for (const std::uint32_t arc : way.arcs) {
      const std::uint32_t given = graph_.given(arc), edge = edges_[given];
      const double length = network_.length(edge);
      const bool with = given == first_[edge] && network_.forward(edge);
      route.legs.push_back({edge, with ? 0 : length, with ? length : 0});
    }
    route.legs.push_back({goal.edge, leg_end(goal, way.target, targets), goal.along});
    std::erase_if(route.legs, [](const RouteLeg& leg) { return leg.from == leg.to; });
    if (route.legs.empty()) route.legs.push_back({goal.edge, goal.along, goal.along});
  }
  for (const RouteLeg& leg : route.legs) route.cost += cost_of(leg);
  return route;
}

}  // namespace stope::planner
