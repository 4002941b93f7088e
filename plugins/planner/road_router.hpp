#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "plugins/planner/road_changes.hpp"
#include "plugins/planner/road_network.hpp"
#include "plugins/planner/route_query.hpp"

namespace stope::planner {

/// A piece of a route: an edge driven from one place of it to another; backward where from > to.
struct RouteLeg {
  std::uint32_t edge = 0;
  double from = 0, to = 0;
};

struct Route {
  std::vector<RouteLeg> legs;
  double cost = 0;
};

/// How cheapest ways are found. All give ways that cost the same.
enum class RouteSearch : int {
  kAStar,      ///< nothing to prepare; looks at a good part of the network
  kLandmarks,  ///< prepared in some full searches; a few percent of the network
  kHierarchy,  ///< prepared in some ten seconds for a million nodes; a few hundred nodes
};

/// Finds cheapest ways between places on roads, again and again, with roads blocked or dearer from
/// query to query. Keeps a reference to the network. Costs are rounded up to whole units of
/// unit_metres(), so that answers are exact in these and depend on no order of summation.
class RoadRouter {
 public:
  explicit RoadRouter(
      const RoadNetwork& network, RouteSearch search = RouteSearch::kAStar,
      const std::function<void()>& pause = [] {});
  ~RoadRouter();
  RoadRouter(const RoadRouter&) = delete;
  RoadRouter& operator=(const RoadRouter&) = delete;

  /// The cheapest way from one place to another, respecting directions and changes; none if there
  /// is no way. The two places split their edges virtually. One query at a time.
  std::optional<Route> find(RoadPlace start, RoadPlace goal, const RoadChanges& changes = {});
  double unit_metres() const { return 1 / units_; }

 private:
  struct Searches;
  enum class Side { kFrom, kTowards };

  std::vector<WayEnd> ends_of(RoadPlace place, Side side, const RoadChanges& changes) const;
  WayCost in_units(double cost) const;
  bool drivable(RoadPlace from, RoadPlace to, const RoadChanges& changes) const;
  Way search(RoadPlace goal, const std::vector<WayEnd>& sources, const std::vector<WayEnd>& targets,
             const CostChanges& changes);

  const RoadNetwork& network_;
  double units_ = 1;  // a metre
  SearchGraph graph_;
  std::vector<std::uint32_t> edges_;  // of each arc as it was given
  std::vector<std::uint32_t> arcs_;   // by how they were given
  std::vector<std::uint32_t> first_;  // of each edge among the arcs as they were given
  std::unique_ptr<Searches> searches_;
};

}  // namespace stope::planner
