#include <fmt/format.h>

#include <string>

#include "plugins/topology/describe_extraction.hpp"
#include "plugins/topology/extract_roads.hpp"
#include "stope/stope.hpp"

namespace stope::topology {

/// Road graph along the generalised Voronoi diagram of the obstacles. See docs/topology.md.
class Voronoi final : public Map<RoadGraph(OccupancyGrid)> {
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
        .ports("grid", "roads");
    describe_extraction(about);
    about
        .param("min_branch", &BranchParams::min_branch, "m", at_least(0.0),
               "A branch that ends must reach this much further than the inscribed circle at its "
               "root.")
        .param("min_branch_share", &BranchParams::min_branch_share, between(0.0, 10.0),
               "… and this share of that circle's radius; corners reach 0.41.");
  }

  RoadGraph apply(const OccupancyGrid& grid, Context& context) const {
    RoadGraph roads = voronoi_roads(grid, params, params, [&] { context.stop_if_cancelled(); });
    report_roads(roads, params, why_none(), context);
    return roads;
  }

 private:
  std::string why_none() const {
    return fmt::format(
        "every way is narrower than twice min_clearance ({} m), or no branch is as long as "
        "min_branch ({} m) and min_branch_share ({}) ask for; lower them, or check the map's "
        "resolution",
        params.min_clearance, params.min_branch, params.min_branch_share);
  }
};

}  // namespace stope::topology

using stope::topology::Voronoi;
STOPE_STAGE(Voronoi, "topology/voronoi")
