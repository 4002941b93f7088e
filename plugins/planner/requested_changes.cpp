#include "plugins/planner/requested_changes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "plugins/planner/road_snap.hpp"
#include "stope/error.hpp"

namespace stope::planner {
namespace {

RoadPlace road_at(const RoadNetwork& network, std::size_t known, const char* what, double x,
                  double y, double most) {
  if (!std::isfinite(x) || !std::isfinite(y))
    throw Error(fmt::format("{} holds a place whose coordinates are not finite", what));
  const auto places =
      nearest_places(network, Vector2(x, y), [known](std::uint32_t edge) { return edge < known; });
  const SnappedPlace& nearest = places.front();
  if (nearest.distance > most) {
    throw Error(fmt::format(
        "{} names the place ({:.2f}, {:.2f}), where no road is; the nearest road is at ({:.2f}, "
        "{:.2f}), {:.1f} m away, farther than the snap_distance of {:.1f} m",
        what, x, y, nearest.position.x(), nearest.position.y(), nearest.distance, most));
  }
  return nearest.place;
}

/// What blocks a place of a road blocks the roads that meet or cross there as well.
void close_around(RoadPlace place, const RoadNetwork& network, std::size_t known,
                  RoadChanges& changes, const std::function<void(std::string_view)>& say) {
  const RoadVertex here = network.at(place);
  const double reach = closed_reach(here.clearance);
  std::vector<std::string> ids;
  for (const SnappedPlace& near : nearest_places(
           network, {here.x, here.y}, [&](std::uint32_t edge) { return edge < known; })) {
    if (near.place.edge != place.edge && near.distance > reach) continue;
    const RoadPlace at = near.place.edge == place.edge ? place : near.place;
    changes.cut(at.edge, at.along);
    ids.push_back(std::to_string(network.graph().edges[at.edge].id));
  }
  if (ids.size() > 1) {
    say(
        fmt::format("closed_places: at ({:.2f}, {:.2f}) {} roads are closed, as all pass within "
                    "{:.1f} m: {}",
                    here.x, here.y, ids.size(), reach, fmt::join(ids, ", ")));
  }
}

std::uint32_t road_with_id(const RoadGraph& graph, std::size_t known, const std::string& text) {
  std::uint64_t id = 0;
  const auto end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, id);
  if (read.ec != std::errc() || read.ptr != end || text.empty())
    throw Error(
        fmt::format("closed_roads holds '{}', which is not the id of a road: ids are whole "
                    "numbers, as the road graph's exports show them",
                    text));
  std::optional<std::uint32_t> nearest;
  const auto distance = [&](std::uint32_t e) {
    const std::uint64_t other = graph.edges[e].id;
    return other > id ? other - id : id - other;
  };
  for (std::uint32_t e = 0; e < std::min(known, graph.edges.size()); ++e)
    if (!nearest || distance(e) < distance(*nearest)) nearest = e;
  if (distance(*nearest) == 0) return *nearest;
  throw Error(fmt::format(
      "closed_roads names the road {}, which the road graph does not have; of its {} the nearest "
      "number is {}",
      id, graph.edges.size() == 1 ? "one road" : fmt::format("{} roads", graph.edges.size()),
      graph.edges[*nearest].id));
}

void expect_groups(const std::vector<double>& numbers, std::size_t size, const char* what,
                   const char* form) {
  if (numbers.size() % size != 0)
    throw Error(fmt::format("{} has {} numbers; they must come as {}", what, numbers.size(), form));
}

}  // namespace

double closed_reach(double clearance) {
  return std::isfinite(clearance) ? std::max(0.5, clearance / 2) : 0.5;
}

RoadChanges resolve(const RequestedChanges& requested, const RoadNetwork& network, double most,
                    const std::function<void(std::string_view)>& say) {
  RoadChanges changes;
  const auto& closed = requested.closed_places;
  const auto& slow = requested.slow_places;
  expect_groups(closed, 2, "closed_places", "[x, y, x, y, …]");
  expect_groups(slow, 3, "slow_places", "[x, y, factor, x, y, factor, …]");
  for (std::size_t i = 0; i < closed.size(); i += 2) {
    const RoadPlace place =
        road_at(network, requested.known_roads, "closed_places", closed[i], closed[i + 1], most);
    close_around(place, network, requested.known_roads, changes, say);
  }
  for (const std::string& id : requested.closed_roads)
    changes.close(road_with_id(network.graph(), requested.known_roads, id));
  for (std::size_t i = 0; i < slow.size(); i += 3) {
    if (!(slow[i + 2] >= 1) || !std::isfinite(slow[i + 2]))
      throw Error(
          fmt::format("slow_places holds the factor {}; a road can only be made dearer, by "
                      "a factor of 1 or more",
                      slow[i + 2]));
    changes.raise(
        road_at(network, requested.known_roads, "slow_places", slow[i], slow[i + 1], most).edge,
        slow[i + 2]);
  }
  return changes;
}

}  // namespace stope::planner
