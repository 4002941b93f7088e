#include "plugins/planner/road_snap.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

#include "plugins/planner/road_search.hpp"

namespace stope::planner {
namespace {

SnappedPlace nearest_on(const RoadNetwork& network, std::uint32_t edge, const Vector2& point) {
  const RoadEdge& road = network.graph().edges[edge];
  SnappedPlace best;
  best.distance = std::numeric_limits<double>::infinity();
  for (std::uint32_t v = road.first_vertex + 1; v < road.first_vertex + road.vertex_count; ++v) {
    const RoadVertex &a = network.graph().vertices[v - 1], &b = network.graph().vertices[v];
    const Vector2 base(a.x, a.y), span(b.x - a.x, b.y - a.y);
    const double square = span.squaredNorm();
    const double fraction =
        square > 0 ? std::clamp(span.dot(point - base) / square, 0.0, 1.0) : 0.0;
    const Vector2 foot = base + fraction * span;
    const double distance = (point - foot).norm();
    if (distance < best.distance) {
      const double along =
          network.along(v - 1) + fraction * (network.along(v) - network.along(v - 1));
      best = {{edge, along}, foot, distance};
    }
  }
  return best;
}

}  // namespace

std::vector<SnappedPlace> nearest_places(const RoadNetwork& network, const Vector2& point,
                                         const std::function<bool(std::uint32_t edge)>& accept) {
  std::vector<SnappedPlace> places;
  for (std::uint32_t e = 0; e < network.graph().edges.size(); ++e) {
    if (network.usable(e) && accept(e)) places.push_back(nearest_on(network, e, point));
  }
  std::sort(places.begin(), places.end(), [](const SnappedPlace& a, const SnappedPlace& b) {
    return std::tie(a.distance, a.place.edge) < std::tie(b.distance, b.place.edge);
  });
  return places;
}

std::vector<SnappedPlace> reachable_places(const RoadNetwork& network, RoadPlace place,
                                           bool against, const Vector2& point,
                                           const RoadChanges& changes) {
  const std::vector<double> costs = costs_from(network, place, against, changes);
  const auto& edges = network.graph().edges;
  const auto joined = [&](std::uint32_t e) {
    const std::uint32_t behind = against ? edges[e].to : edges[e].from;
    const std::uint32_t before = against ? edges[e].from : edges[e].to;
    return !changes.closed(e) && ((network.forward(e) && std::isfinite(costs[behind])) ||
                                  (network.backward(e) && std::isfinite(costs[before])));
  };
  return nearest_places(network, point, joined);
}

}  // namespace stope::planner
