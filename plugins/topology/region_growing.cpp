#include <fmt/format.h>

#include <optional>
#include <string>
#include <tuple>

#include "plugins/topology/regions/describe_regions.hpp"
#include "plugins/topology/regions/segment_by_growth.hpp"
#include "stope/stope.hpp"

namespace stope::topology {

/// Convex regions that grow from points of the trajectory and of free space. See docs/regions.md.
class RegionGrowing final
    : public Map<Outputs<RoadGraph, RegionMap>(OccupancyGrid, Optional<Trajectory>)> {
 public:
  struct Params : ExtractionParams, NetworkParams, GrowingParams {
    std::string mode = "default";
  } params;

  static void describe(About<RegionGrowing>& about) {
    about
        .summary(
            "Convex regions of free space that grow in rings from the trajectory or from the "
            "middle of free space, and the roads between them.")
        .from("Wang et al. 2019, Topological Map Construction Based on Region Dynamic Growing")
        .notes(
            "The lengths are for a mine; for rooms give growth_radius 1.2 m, max_radius 3 m, "
            "second_radius 3 m, merge_radius 0.8 m, merge_area 30 m^2. mode: paper follows the "
            "printed algorithms to the letter, random growth points and spanning tree included. "
            "Keeps memory of the grid before: where `changed` says that only a window differs, "
            "what grew elsewhere is used again, with the same result.")
        .in_order()
        .ports("grid", "trajectory", "roads", "regions");
    describe_extraction(about);
    describe_network(about);
    about
        .param("mode", &Params::mode, one_of({"default", "paper"}),
               "What works, or the paper to the letter: docs/regions.md lists where they differ.")
        .param("growth_radius", &Params::growth_radius, "m", more_than(0.0),
               "Growth radius R_max that a region starts with.")
        .param("max_radius", &Params::max_radius, "m", more_than(0.0),
               "Bound of the growth radius, which the paper has not.")
        .param("radius_weight", &Params::radius_weight, at_least(0.0),
               "Control weight R_w of the growth radius.")
        .param("addition_ratio", &Params::addition_ratio, between(0.0, 1.0),
               "r_a: a ring of which a smaller share qualifies is the last.")
        .param("obstacle_ratio", &Params::obstacle_ratio, at_least(0.0),
               "r_o: most unqualified points in a region's convex hull for each qualified one.")
        .param("second_radius", &Params::second_radius, "m", at_least(0.0),
               "How far regions grow into what is left, in secondary growth.")
        .param("merge_radius", &Params::merge_radius, "m", at_least(0.0),
               "Regions with a smaller radius are merged with a neighbour if they can.")
        .param("merge_area", &Params::merge_area, "m^2", at_least(0.0),
               "Largest area of a merged region.")
        .param("merge_obstacle_ratio", &Params::merge_obstacle_ratio, at_least(0.0),
               "Most unqualified points in a merged region's hull for each qualified one.")
        .param("min_region_area", &Params::min_region_area, "m^2", at_least(0.0),
               "Parts of free space that are smaller are left out, but never the largest.")
        .param("coverage", &Params::coverage, between(0.0, 1.0),
               "mode: paper stops drawing growth points when this share of free space is covered.");
  }

  std::tuple<RoadGraph, RegionMap> apply(const OccupancyGrid& grid,
                                         const Optional<Trajectory>& trajectory,
                                         Context& context) const {
    const auto checkpoint = [&] { context.stop_if_cancelled(); };
    const bool follows = ground_ && grid.changed && last_ == grid.changed->since;
    last_.reset();
    std::optional<GroundChange> change;
    if (follows) change.emplace(ground_->width(), ground_->height());
    const auto updated = [&] {
      return follows && ground_->update(grid,
                                        {grid.changed->column, grid.changed->row,
                                         grid.changed->width, grid.changed->height},
                                        *change, checkpoint);
    };
    if (!updated()) {
      change.reset();
      ground_.emplace(grid, params, checkpoint);
    }
    const std::vector<CellIndex> visited = visited_cells(*ground_, trajectory, context);
    // A map that does not tell what changed, and paper's random points, are not worth the memory.
    const bool remember = grid.changed && params.mode != "paper";
    RegionsAndRoads result =
        remember ? segment_by_growth(*ground_, visited, growing(), roads_rule(params, params),
                                     memory_, change ? &*change : nullptr, checkpoint)
                 : segment_by_growth(std::move(*ground_), visited, growing(),
                                     roads_rule(params, params), context.random(), checkpoint);
    if (remember) {
      last_ = context.index();
    } else {
      ground_.reset();
      memory_ = {};
    }
    report_regions(result, params, false, context);
    return {std::move(result.roads), std::move(result.map)};
  }

 private:
  GrowingParams growing() const {
    GrowingParams growing = params;
    growing.as_printed = params.mode == "paper";
    return growing;
  }

  static std::vector<CellIndex> visited_cells(const Ground& ground,
                                              const Optional<Trajectory>& trajectory,
                                              Context& context) {
    if (!trajectory) return {};
    std::size_t outside = 0, blocked = 0;
    std::vector<CellIndex> cells = cells_visited(ground, *trajectory, outside, blocked);
    if (outside + blocked > 0)
      context.warn(fmt::format(
          "{} of the trajectory's {} poses lie outside of the map and {} in cells that are not "
          "free: no region grows from them{}",
          outside, trajectory->poses.size(), blocked,
          cells.empty() ? ". None is left, so regions grow from the middle of free space; check "
                          "that map and trajectory are in the same frame"
                        : ""));
    return cells;
  }

  // What the item before left, and its index; none if it failed.
  mutable std::optional<Ground> ground_;
  mutable GrowthMemory memory_;
  mutable std::optional<std::uint64_t> last_;
};

}  // namespace stope::topology

using stope::topology::RegionGrowing;
STOPE_STAGE(RegionGrowing, "topology/region_growing")
