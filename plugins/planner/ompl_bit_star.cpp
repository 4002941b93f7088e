#include <algorithm>
#include <cmath>

#include "plugins/planner/planner_params.hpp"
#include "plugins/planner/sampled_roads.hpp"

namespace stope::planner {

class OmplBitStar final
    : public Map<Path(RoadGraph, Optional<StampedPose>, Optional<OccupancyGrid>)> {
 public:
  struct Params : PlannerParams {
    std::uint32_t iterations = 20000;
    std::uint32_t batch = 200;
  } params;

  static void describe(About<OmplBitStar>& about) {
    about
        .summary(
            "Plans the shortest way through free ground around the road graph, by batches of "
            "informed samples.")
        .from("Gammell, Barfoot and Srinivasa, Batch Informed Trees, IJRR 2020; OMPL's BITstar")
        .notes(
            "The road graph's vertices are the first samples; random ones within the clearance of "
            "open roads follow. The way by road is planned as well, as a_star does, and the better "
            "of the two is taken, with clearance counted as the rules say. Without a grid it plans "
            "as a_star does. OMPL keeps a generator inside it that cannot be seeded: the samples "
            "are "
            "the same for the same run seed, the choice between equals may not be.")
        .nondeterministic();
    describe_planner(about)
        .param("iterations", &Params::iterations, between(1, 10000000),
               "Steps of the search, each an edge looked at or a batch drawn.")
        .param("batch", &Params::batch, between(1, 100000), "Samples drawn at a time.");
  }

  Path apply(const RoadGraph& roads, const Optional<StampedPose>& pose,
             const Optional<OccupancyGrid>& grid, Context& context) const {
    const PlanRequest request = request_of(params, pose);
    const auto say = [&](std::string_view sentence) { context.info(sentence); };
    RoadPlanner by_road(roads, request.rules);
    Path path = by_road.plan(grid ? &*grid : nullptr, request, say);
    if (grid && path.points.size() > 1) {
      const PathPoint &first = path.points.front(), &last = path.points.back();
      const DrivableGrid drivable(*grid);
      const RoadNetwork network(roads, request.rules);
      const FreeGround ground(drivable, network, request.changes, request.snap_distance);
      const auto way = bit_star_way(ground, network, {first.x, first.y}, {last.x, last.y},
                                    params.iterations, params.batch, context.seed());
      if (way) {
        RoadGraph only;
        add_way(only, *way, ground);
        PlanRequest along = request;
        along.start = {first.x, first.y};
        along.goal = {last.x, last.y};
        along.changes = {};
        along.avoid_obstructed = along.shortcut = false;
        Path other = RoadPlanner(only, request.rules).plan(nullptr, along, say);
        if (cost_of(other) < cost_of(path)) {
          other.edges.clear();
          path = std::move(other);
          context.info("the way through free ground is the better one: it follows no road");
        }
      }
    }
    say_planned(path, context);
    return path;
  }

 private:
  /// What the rules make of a path's points.
  double cost_of(const Path& path) const {
    double cost = 0;
    for (std::size_t i = 1; i < path.points.size(); ++i) {
      const PathPoint &a = path.points[i - 1], &b = path.points[i];
      const double clearance = std::min(a.clearance, b.clearance);
      const double short_of =
          params.comfortable_clearance > 0 && std::isfinite(clearance)
              ? std::clamp(1 - clearance / params.comfortable_clearance, 0.0, 1.0)
              : 0;
      cost += std::hypot(b.x - a.x, b.y - a.y) * (1 + params.clearance_weight * short_of);
    }
    return cost;
  }
};

STOPE_STAGE(OmplBitStar, "planner/ompl_bit_star")

}  // namespace stope::planner
