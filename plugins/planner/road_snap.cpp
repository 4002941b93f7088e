#include "plugins/planner/road_snap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "plugins/planner/road_search.hpp"

namespace stope::planner {
namespace {

/// Metres along an edge, from and to.
struct Stretch {
  double from = 0, to = 0;
};

SnappedPlace nearest_on(const RoadNetwork& network, std::uint32_t edge, const Stretch& stretch,
                        const Vector2& point) {
  const RoadEdge& road = network.graph().edges[edge];
  SnappedPlace best;
  best.distance = std::numeric_limits<double>::infinity();
  if (stretch.from > stretch.to) return best;
  for (std::uint32_t v = road.first_vertex + 1; v < road.first_vertex + road.vertex_count; ++v) {
    const double begin = network.along(v - 1), length = network.along(v) - begin;
    const double least = length > 0 ? (stretch.from - begin) / length : 0;
    const double most = length > 0 ? (stretch.to - begin) / length : 1;
    if (least > 1 || most < 0) continue;
    const RoadVertex &a = network.graph().vertices[v - 1], &b = network.graph().vertices[v];
    const Vector2 base(a.x, a.y), span(b.x - a.x, b.y - a.y);
    const double square = span.squaredNorm();
    const double foot_at = square > 0 ? span.dot(point - base) / square : 0;
    const double fraction = std::clamp(foot_at, std::max(0.0, least), std::min(1.0, most));
    const Vector2 foot = base + fraction * span;
    const double distance = (point - foot).norm();
    if (distance < best.distance) best = {{edge, begin + fraction * length}, foot, distance};
  }
  return best;
}

constexpr double kWhole = std::numeric_limits<double>::infinity();
constexpr double kBeforeCut = 0.1;  // metres: the place of a cut itself cannot be driven to

/// What of an edge can be driven, going up or down from a place of it, until the first cut.
Stretch until_cut(std::uint32_t edge, double from, bool up, const RoadChanges& changes) {
  Stretch open{up ? from : -kWhole, up ? kWhole : from};
  const auto found = changes.all().find(edge);
  if (found == changes.all().end()) return open;
  for (const double cut : found->second.cuts) {
    if (up && cut >= from) open.to = std::min(open.to, cut - kBeforeCut);
    if (!up && cut <= from) open.from = std::max(open.from, cut + kBeforeCut);
  }
  return open;
}

void sort_by_distance(std::vector<SnappedPlace>& places) {
  std::sort(places.begin(), places.end(), [](const SnappedPlace& a, const SnappedPlace& b) {
    return std::tie(a.distance, a.place.edge) < std::tie(b.distance, b.place.edge);
  });
}

}  // namespace

std::vector<SnappedPlace> nearest_places(const RoadNetwork& network, const Vector2& point,
                                         const std::function<bool(std::uint32_t edge)>& accept) {
  std::vector<SnappedPlace> places;
  for (std::uint32_t e = 0; e < network.graph().edges.size(); ++e) {
    if (network.usable(e) && accept(e))
      places.push_back(nearest_on(network, e, {-kWhole, kWhole}, point));
  }
  sort_by_distance(places);
  return places;
}

std::vector<SnappedPlace> reachable_places(const RoadNetwork& network, RoadPlace place,
                                           bool against, const Vector2& point,
                                           const RoadChanges& changes) {
  const std::vector<double> costs = costs_from(network, place, against, changes);
  const auto& edges = network.graph().edges;
  std::vector<SnappedPlace> places;
  for (std::uint32_t e = 0; e < edges.size(); ++e) {
    if (!network.usable(e) || changes.closed(e)) continue;
    const bool up = against ? network.backward(e) : network.forward(e);
    const bool down = against ? network.forward(e) : network.backward(e);
    SnappedPlace best;
    best.distance = kWhole;
    const auto take = [&](double from, bool upwards) {
      const SnappedPlace found =
          nearest_on(network, e, until_cut(e, from, upwards, changes), point);
      if (found.distance < best.distance) best = found;
    };
    if (up && std::isfinite(costs[edges[e].from])) take(0, true);
    if (down && std::isfinite(costs[edges[e].to])) take(network.length(e), false);
    if (up && e == place.edge) take(place.along, true);
    if (down && e == place.edge) take(place.along, false);
    if (std::isfinite(best.distance)) places.push_back(best);
  }
  sort_by_distance(places);
  return places;
}

}  // namespace stope::planner
