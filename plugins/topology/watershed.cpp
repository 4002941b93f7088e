#include <fmt/format.h>

#include <string>

#include "plugins/topology/describe_extraction.hpp"
#include "plugins/topology/extract_roads.hpp"
#include "stope/stope.hpp"

namespace stope::topology {

/// Road graph along the watershed of the distance to obstacles. See docs/topology.md.
class Watershed final : public Map<RoadGraph(OccupancyGrid)> {
 public:
  struct Params : ExtractionParams {
  } params;

  static void describe(About<Watershed>& about) {
    about.summary("Road graph along the watershed of the distance to obstacles.")
        .from(
            "Huang, Tian and Xia, Automatic Construction Method of Topological Map of Obstacles "
            "in Mining Area, sec. V; flooding after Meyer 1991, 1994")
        .notes(
            "A watershed line separates two obstacles, so it cannot end in free space: dead ends "
            "(loading faces, dumps) are lost by construction, and free space without holes has "
            "no road at all. Use topology/voronoi where dead ends matter.")
        .ports("grid", "roads");
    describe_extraction(about);
  }

  RoadGraph apply(const OccupancyGrid& grid, Context& context) const {
    RoadGraph roads = watershed_roads(grid, params, [&] { context.stop_if_cancelled(); });
    report_roads(roads, params, why_none(), context);
    return roads;
  }

 private:
  std::string why_none() const {
    return fmt::format(
        "a watershed separates obstacles, so it needs at least one obstacle or hole inside the "
        "free space that is larger than min_obstacle_area ({} m^2), and ways round it wider than "
        "twice min_clearance ({} m); topology/voronoi also finds roads without loops",
        params.min_obstacle_area, params.min_clearance);
  }
};

}  // namespace stope::topology

using stope::topology::Watershed;
STOPE_STAGE(Watershed, "topology/watershed")
