#include <algorithm>
#include <cmath>

#include "plugins/planner/planner_params.hpp"
#include "plugins/planner/sampled_roads.hpp"

namespace stope::planner {

class OmplPrm final : public Map<Path(RoadGraph, Optional<StampedPose>, Optional<OccupancyGrid>)> {
 public:
  struct Params : PlannerParams {
    std::uint32_t samples = 500;
    std::uint32_t neighbours = 10;
  } params;

  static void describe(About<OmplPrm>& about) {
    about
        .summary(
            "Plans the cheapest way along the road graph and through free ground beside it, by a "
            "probabilistic roadmap.")
        .from("Kavraki, Svestka, Latombe and Overmars 1996; OMPL's PRM")
        .notes(
            "The road graph's nodes are the roadmap's first milestones; random ones within the "
            "clearance of open roads join them through ground that the grid shows free. What is "
            "found is searched as a_star does, with the same rules. Without a grid it plans as "
            "a_star does. The same for the same run seed on any number of threads.");
    describe_planner(about)
        .param("samples", &Params::samples, at_most(20000),
               "Random milestones added to the road graph's nodes.")
        .param("neighbours", &Params::neighbours, between(1, 100),
               "Nearest milestones each is joined to, where it sees them.");
  }

  Path apply(const RoadGraph& roads, const Optional<StampedPose>& pose,
             const Optional<OccupancyGrid>& grid, Context& context) const {
    PlanRequest request = request_of(params, pose);
    request.changes.known_roads = roads.edges.size();
    const auto say = [&](std::string_view sentence) { context.info(sentence); };
    RoadPlanner by_road(roads, request.rules);
    if (!grid) {
      context.info("no grid is wired, so there is no free ground to draw from: planned by road");
      Path path = by_road.plan(nullptr, request, say);
      say_planned(path, context);
      return path;
    }
    request = by_road.with_ends(*grid, request, say);
    RoadGraph enlarged = roads;
    {
      const DrivableGrid drivable(*grid);
      const RoadNetwork network(roads, request.rules);
      const FreeGround ground(drivable, network, request.changes, request.snap_distance);
      add_prm_roads(enlarged, ground, network, params.samples, params.neighbours, context.seed());
    }
    Path path = RoadPlanner(enlarged, request.rules).plan(&*grid, request, say);
    std::erase(path.edges, 0U);
    say_planned(path, context);
    return path;
  }
};

STOPE_STAGE(OmplPrm, "planner/ompl_prm")

}  // namespace stope::planner
