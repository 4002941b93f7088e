#include <memory>
#include <string>
#include <tuple>

#include "plugins/topology/regions/clearance_basins.hpp"
#include "plugins/topology/regions/describe_regions.hpp"
#include "stope/stope.hpp"

namespace stope::topology {

/// Rooms, divided at the doors of the Voronoi diagram. See docs/regions.md.
class VoronoiRegions final
    : public Map<Outputs<RoadGraph, RegionMap>(OccupancyGrid, Optional<Trajectory>)> {
 public:
  struct Params : ExtractionParams, NetworkParams {
    double door_ratio = 0.93;
    double similar_ratio = 0.8;
    double min_region_area = 50.0;
  } params;

  static void describe(About<VoronoiRegions>& about) {
    about
        .summary(
            "Rooms, yards and the like: free space divided where it is narrow, and the roads "
            "through the doors.")
        .from(
            "critical lines of the Voronoi diagram after Thrun 1998; survey of Bormann et al. "
            "2016; doors chosen by how much they narrow the way")
        .notes(
            "A door is a place of least clearance along the Voronoi diagram, at most door_ratio of "
            "the clearance on both sides. For rooms give min_region_area 1 m^2, min_clearance 0.2 "
            "m, min_obstacle_area 1 m^2. The trajectory is not looked at; it is there so that "
            "region_growing can stand in.")
        .ports("grid", "trajectory", "roads", "regions");
    describe_extraction(about);
    describe_network(about);
    about
        .param("door_ratio", &Params::door_ratio, between(0.0, 1.0),
               "Widest door, as a share of the width of the narrower of the two regions it joins.")
        .param("similar_ratio", &Params::similar_ratio, between(0.0, 1.0),
               "… and as a share of the geometric mean of both: a corridor's pieces stay together.")
        .param("min_region_area", &Params::min_region_area, "m^2", at_least(0.0),
               "Smaller regions join the neighbour they are most open to.");
  }

  std::tuple<RoadGraph, RegionMap> apply(const OccupancyGrid& grid, const Optional<Trajectory>&,
                                         Context& context) const {
    const auto checkpoint = [&] { context.stop_if_cancelled(); };
    const Ground ground(grid, params, checkpoint);
    const double cell = grid.frame.resolution * grid.frame.resolution;
    std::int32_t count = 0;
    const RegionCells regions = divide_at_doors(
        ground, {params.door_ratio, params.similar_ratio, params.min_region_area / cell}, count,
        checkpoint);
    RegionsAndRoads result =
        finish_regions(ground, regions, count, roads_rule(params, params), checkpoint);
    report_regions(result, params, context);
    return {std::move(result.roads), std::move(result.map)};
  }
};

}  // namespace stope::topology

using stope::topology::VoronoiRegions;
STOPE_STAGE(VoronoiRegions, "topology/voronoi_regions")
