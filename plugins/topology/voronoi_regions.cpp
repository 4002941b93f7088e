#include <optional>
#include <tuple>

#include "plugins/topology/regions/describe_regions.hpp"
#include "plugins/topology/regions/room_divider.hpp"
#include "stope/stope.hpp"

namespace stope::topology {

/// Rooms, divided at the doors of the Voronoi diagram. See docs/regions.md.
class VoronoiRegions final
    : public Map<Outputs<RoadGraph, RegionMap>(OccupancyGrid, Optional<Trajectory>)> {
 public:
  struct Params : ExtractionParams, NetworkParams, RoomDivider::Rule {
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
            "the clearance on both sides. For rooms give door_ratio 0.99, similar_ratio 0.88, "
            "hub_ratio 0.64, min_region_area 1 m^2, min_clearance 0.2 "
            "m, min_obstacle_area 1 m^2. The trajectory is not looked at; it is there so that "
            "region_growing can stand in. Where `changed` says that only a window differs from "
            "the grid before, only what that can reach is computed, with the same result.")
        .ports("grid", "trajectory", "roads", "regions");
    describe_extraction(about);
    describe_network(about);
    about
        .param("door_ratio", &Params::door_ratio, between(0.0, 1.0),
               "Widest door, as a share of the width of the narrower of the two regions it joins.")
        .param("similar_ratio", &Params::similar_ratio, between(0.0, 1.0),
               "… and as a share of the geometric mean of both: a corridor's pieces stay together.")
        .param("hub_ratio", &Params::hub_ratio, between(0.0, 1.0),
               "Regions with three or more neighbours each become one where their door is at least "
               "this share of the wider one's width: corridors of a building. 1: never.")
        .param(
            "min_region_area", &Params::min_region_area, "m^2", at_least(0.0),
            "Smaller regions join the neighbour they are most open to; one that has none is left "
            "out, but never the largest.");
  }

  std::tuple<RoadGraph, RegionMap> apply(const OccupancyGrid& grid, const Optional<Trajectory>&,
                                         Context& context) const {
    const auto checkpoint = [&] { context.stop_if_cancelled(); };
    if (!divider_) divider_.emplace(params, params, roads_rule(params, params));
    const bool follows = grid.changed && last_ == grid.changed->since;
    last_.reset();
    // Single maps do not pay for the memory that a stream of changing ones is worth.
    RegionsAndRoads result = follows ? divider_->update(grid,
                                                        {grid.changed->column, grid.changed->row,
                                                         grid.changed->width, grid.changed->height},
                                                        checkpoint)
                                     : divider_->full(grid, grid.changed.has_value(), checkpoint);
    if (grid.changed) last_ = context.index();
    report_regions(result, params, true, context);
    return {std::move(result.roads), std::move(result.map)};
  }

 private:
  mutable std::optional<RoomDivider> divider_;
  mutable std::optional<std::uint64_t> last_;  ///< index of the item it knows; none if that failed
};

}  // namespace stope::topology

using stope::topology::VoronoiRegions;
STOPE_STAGE(VoronoiRegions, "topology/voronoi_regions")
