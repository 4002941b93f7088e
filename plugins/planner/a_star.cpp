#include <memory>
#include <optional>
#include <string>

#include "plugins/planner/planner_params.hpp"
#include "stope/digest.hpp"

namespace stope::planner {

class AStar final : public Map<Path(RoadGraph, Optional<StampedPose>, Optional<OccupancyGrid>)> {
 public:
  struct Params : PlannerParams {
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
        .in_order();
    describe_planner(about).param(
        "search", &Params::search, one_of({"a_star", "landmarks", "hierarchy"}),
        "How ways are found; all are as cheap. landmarks and hierarchy prepare the network, "
        "for many queries on large ones.");
  }

  Path apply(const RoadGraph& roads, const Optional<StampedPose>& pose,
             const Optional<OccupancyGrid>& grid, Context& context) const {
    const PlanRequest request = request_of(params, pose);
    Path path = prepared(roads, request.rules, context)
                    .plan(grid ? &*grid : nullptr, request,
                          [&](std::string_view sentence) { context.info(sentence); });
    say_planned(path, context);
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
