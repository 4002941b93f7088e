#include <fmt/format.h>

#include <optional>
#include <vector>

#include "plugins/planner/plan.hpp"
#include "stope/stope.hpp"

namespace stope::planner {

class AStar final : public Map<Path(RoadGraph, Optional<OccupancyGrid>)> {
 public:
  struct Params {
    std::optional<std::vector<double>> start, goal;
    double snap_distance = 50;
    double min_clearance = 0;
    double comfortable_clearance = 10;
    double clearance_weight = 0;
    double step = 1;
    double smoothing = 2;
  } params;

  static void describe(About<AStar>& about) {
    about.summary("Plans the cheapest way along the road graph, from start to goal.")
        .from("Hart, Nilsson and Raphael 1968; Huang et al., Obstacles in Mining Area, sec. V")
        .notes(
            "Start and goal are joined to the nearest place on a road, through free cells if a "
            "grid is wired. Closed roads and one-way directions are respected. Without start or "
            "goal the far ends of the largest part of the network are taken; on a ring the goal "
            "is the place across it.")
        .ports("roads", "grid", "path")
        .param("start", &Params::start, "m", count(2, 2),
               "Where to start, [x, y] in the map frame.")
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
               "Distance before and behind a point over which heading and curvature are taken.");
  }

  Path apply(const RoadGraph& roads, const Optional<OccupancyGrid>& grid, Context& context) const {
    PlanRequest request;
    request.start = params.start;
    request.goal = params.goal;
    request.snap_distance = params.snap_distance;
    request.step = params.step;
    request.smoothing = params.smoothing;
    request.rules = {params.min_clearance, params.comfortable_clearance, params.clearance_weight};
    Path path = plan_path(roads, grid ? &*grid : nullptr, request,
                          [&](std::string_view sentence) { context.info(sentence); });
    context.info(fmt::format("planned {:.1f} m along {} {}", path.length, path.edges.size(),
                             path.edges.size() == 1 ? "road" : "roads"));
    return path;
  }
};

STOPE_STAGE(AStar, "planner/a_star")

}  // namespace stope::planner
