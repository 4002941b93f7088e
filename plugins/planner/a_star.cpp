#include <fmt/format.h>

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "plugins/planner/plan.hpp"
#include "stope/digest.hpp"
#include "stope/stope.hpp"

namespace stope::planner {

class AStar final : public Map<Path(RoadGraph, Optional<StampedPose>, Optional<OccupancyGrid>)> {
 public:
  struct Params {
    std::optional<std::vector<double>> start, goal;
    double snap_distance = 50;
    double min_clearance = 0;
    double comfortable_clearance = 10;
    double clearance_weight = 0;
    double step = 1;
    double smoothing = 2;
    std::vector<double> closed_places, slow_places;
    std::vector<std::string> closed_roads;
    bool avoid_obstructed = true;
    std::string search = "a_star";
  } params;

  static void describe(About<AStar>& about) {
    about.summary("Plans the cheapest way along the road graph, from start to goal.")
        .from("Hart, Nilsson and Raphael 1968; Huang et al., Obstacles in Mining Area, sec. V")
        .notes(
            "Start and goal are joined to the nearest place on a road, through free cells if a "
            "grid is wired. Closed roads and one-way directions are respected, and roads on which "
            "the grid shows an obstacle now are driven round. Without start or goal the far ends "
            "of the largest part of the network are taken; on a ring the goal is the place across "
            "it. What is prepared for a search is kept while the roads stay the same: with live "
            "grids or poses and a large network take search: hierarchy.")
        .ports("roads", "pose", "grid", "path")
        .in_order()
        .param("start", &Params::start, "m", count(2, 2),
               "Where to start, [x, y] in the map frame; a wired pose comes before it.")
        .param("goal", &Params::goal, "m", count(2, 2), "Where to go, [x, y] in the map frame.")
        .param("snap_distance", &Params::snap_distance, "m", at_least(0.0),
               "How far start and goal may lie from a road.")
        .param("min_clearance", &Params::min_clearance, "m", at_least(0.0),
               "Roads that come nearer to an obstacle than this are not driven.")
        .param("comfortable_clearance", &Params::comfortable_clearance, "m", at_least(0.0),
               "Beyond this clearance a road costs no more than its length.")
        .param("clearance_weight", &Params::clearance_weight, at_least(0.0),
               "How much dearer a metre without any clearance is; 0 plans the shortest way.")
        .param("step", &Params::step, "m", more_than(0.0), "Greatest distance between points.")
        .param("smoothing", &Params::smoothing, "m", more_than(0.0),
               "Distance before and behind a point over which heading and curvature are taken.")
        .param("closed_places", &Params::closed_places, "m", any(),
               "Places [x, y, x, y, …] where the nearest road cannot be passed now.")
        .param("closed_roads", &Params::closed_roads, "Ids of road edges that are closed now.")
        .param("slow_places", &Params::slow_places,
               "[x, y, factor, …]: the road nearest to (x, y) costs factor times as much now.")
        .param("avoid_obstructed", &Params::avoid_obstructed,
               "Whether to drive round roads on which the grid shows an obstacle now.")
        .param("search", &Params::search, one_of({"a_star", "landmarks", "hierarchy"}),
               "How ways are found; all are as cheap. landmarks and hierarchy prepare the network, "
               "for many queries on large ones.");
  }

  Path apply(const RoadGraph& roads, const Optional<StampedPose>& pose,
             const Optional<OccupancyGrid>& grid, Context& context) const {
    PlanRequest request;
    request.start = params.start;
    request.goal = params.goal;
    if (pose) {
      const auto& place = pose->T_map_lidar.translation;
      request.start = {place.x(), place.y()};
    }
    request.snap_distance = params.snap_distance;
    request.step = params.step;
    request.smoothing = params.smoothing;
    request.rules = {params.min_clearance, params.comfortable_clearance, params.clearance_weight};
    request.changes = {params.closed_places, params.closed_roads, params.slow_places};
    request.avoid_obstructed = params.avoid_obstructed;
    Path path = prepared(roads, request.rules, context)
                    .plan(grid ? &*grid : nullptr, request,
                          [&](std::string_view sentence) { context.info(sentence); });
    context.info(fmt::format("planned {:.1f} m along {} {}", path.length, path.edges.size(),
                             path.edges.size() == 1 ? "road" : "roads"));
    return path;
  }

 private:
  struct Prepared {
    Digest digest;
    RoadGraph roads;
    std::optional<RoadPlanner> planner;
  };

  RoadPlanner& prepared(const RoadGraph& roads, const RoadRules& rules, Context& context) const {
    const Digest digest = digest_of(roads);
    if (!prepared_ || !(prepared_->digest == digest)) {
      prepared_.reset();
      auto made = std::make_unique<Prepared>();
      made->digest = digest;
      made->roads = roads;
      const RouteSearch search = params.search == "landmarks"   ? RouteSearch::kLandmarks
                                 : params.search == "hierarchy" ? RouteSearch::kHierarchy
                                                                : RouteSearch::kAStar;
      made->planner.emplace(made->roads, rules, search, [&] { context.stop_if_cancelled(); });
      prepared_ = std::move(made);
    }
    return *prepared_->planner;
  }

  mutable std::unique_ptr<Prepared> prepared_;
};

STOPE_STAGE(AStar, "planner/a_star")

}  // namespace stope::planner
