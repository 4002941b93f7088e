#include <fmt/format.h>

#include "plugins/metric/check_graph.hpp"
#include "plugins/metric/disc_union.hpp"
#include "plugins/metric/measure_list.hpp"
#include "stope/stope.hpp"

namespace stope::metric {

class Coverage final : public Map<Measures(RoadGraph, OccupancyGrid)> {
 public:
  struct Params : FreeRule {
  } params;

  static void describe(About<Coverage>& about) {
    about.summary("Share of free space in discs round the graph's points that touch obstacles.")
        .from("Blum 1967: the discs of the whole medial axis cover all")
        .notes(
            "The area of the union of discs, each round a point of the graph and as large as its "
            "clearance, over the free area. Clearances are measured on the grid, exactly; those "
            "in the graph are not used. A graph without nodes covers nothing.")
        .ports("roads", "grid", "measures");
    describe_free_rule(about);
  }

  Measures apply(const RoadGraph& roads, const OccupancyGrid& grid, Context&) const {
    check_graph(roads, "roads");
    const FreeCells cells = free_cells(grid, params);
    const double share =
        static_cast<double>(cells_in_discs(roads, cells)) / static_cast<double>(cells.count);
    const double area =
        static_cast<double>(cells.count) * grid.frame.resolution * grid.frame.resolution;
    return MeasureList(fmt::format("discs as large as the clearance measured on the grid, by cell "
                                   "centres of {} m; {:.0f} m^2 free",
                                   grid.frame.resolution, area))
        .add("coverage", share)
        .take();
  }
};

STOPE_STAGE(Coverage, "metric/coverage")

}  // namespace stope::metric
