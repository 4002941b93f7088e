#include "plugins/topology/describe_extraction.hpp"
#include "plugins/topology/remember_roads.hpp"
#include "stope/stope.hpp"

namespace stope::topology {

/// Road graph along the generalised Voronoi diagram of the obstacles. See docs/topology.md.
class Voronoi final : public Map<RoadGraph(OccupancyGrid, Optional<ElevationGrid>)> {
 public:
  struct Params : ExtractionParams, BranchParams {
  } params;

  static void describe(About<Voronoi>& about) {
    about
        .summary(
            "Road graph along the generalised Voronoi diagram of the obstacles, with dead ends.")
        .from(
            "boundary-distance pruning after Ogniewicz and Kuebler 1995 and Telea and van Wijk "
            "2002; branches by erosion thickness after Liu et al. 2011")
        .notes(
            "Keeps a dead end if it reaches further than min_branch beyond the road it leaves "
            "and further than min_branch_share times its own half width; ends it where its full "
            "width ends. Every hole keeps its cycle, every piece of free space stays connected.")
        .ports("grid", "elevation", "roads");
    describe_extraction(about);
    describe_branches(about);
    describe_lines(about);
  }

  RoadGraph apply(const OccupancyGrid& grid, const Optional<ElevationGrid>& elevation,
                  Context& context) const {
    RoadGraph roads =
        memory_.extract(grid, {ExtractionMethod::Kind::kVoronoi, params, params, {}, {}}, context);
    report_roads(roads, params, why_no_branches(params, params), context);
    if (elevation) give_elevation(roads, *elevation);
    return roads;
  }

 private:
  mutable RememberRoads memory_;
};

}  // namespace stope::topology

using stope::topology::Voronoi;
STOPE_STAGE(Voronoi, "topology/voronoi")
