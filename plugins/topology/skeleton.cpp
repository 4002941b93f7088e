#include <fmt/format.h>

#include <string>

#include "plugins/topology/describe_extraction.hpp"
#include "plugins/topology/remember_roads.hpp"
#include "stope/stope.hpp"

namespace stope::topology {

/// Road graph along the medial axis of free space. See docs/topology.md.
class Skeleton final : public Map<RoadGraph(OccupancyGrid, Optional<ElevationGrid>)> {
 public:
  struct Params : ExtractionParams, BranchParams {
    std::string pruning = "chord_residual";
    double residual = SkeletonParams{}.residual;
    double lambda = SkeletonParams{}.lambda;
  } params;

  static void describe(About<Skeleton>& about) {
    about.summary("Road graph along the medial axis of free space, with dead ends.")
        .from(
            "chord residual after Ogniewicz and Kuebler 1995; lambda-medial axis after Chazal and "
            "Lieutier 2005; branches by erosion thickness after Liu et al. 2011")
        .notes(
            "Where topology/voronoi asks how far two sides are apart along the outline, this asks "
            "how much longer that way is than the straight one (chord_residual) or how far they "
            "are apart in space (lambda), so that winding but open walls give fewer lines to "
            "judge. "
            "Every hole keeps its cycle, every piece of free space stays connected, dead ends are "
            "kept by the same rule.")
        .ports("grid", "elevation", "roads");
    describe_extraction(about);
    describe_branches(about);
    describe_lines(about);
    about
        .param("pruning", &Params::pruning, one_of({"chord_residual", "lambda"}),
               "Which part of the medial axis is looked at: by the way along the outline between "
               "the two places a point sees, or by their distance.")
        .param("residual", &Params::residual, "m", at_least(0.0),
               "chord_residual: how much longer the outline between the two places must be than "
               "the straight way; at least two cells.")
        .param("lambda", &Params::lambda, "m", at_least(0.0),
               "lambda: how far the two places must be apart; at least four cells. Dead ends that "
               "are narrower than this are lost.");
  }

  RoadGraph apply(const OccupancyGrid& grid, const Optional<ElevationGrid>& elevation,
                  Context& context) const {
    const auto pruning = params.pruning == "lambda" ? SkeletonParams::Pruning::kLambda
                                                    : SkeletonParams::Pruning::kChordResidual;
    RoadGraph roads = memory_.extract(grid,
                                      {ExtractionMethod::Kind::kSkeleton,
                                       params,
                                       params,
                                       {pruning, params.residual, params.lambda},
                                       {}},
                                      context);
    report_roads(roads, params, why_no_branches(params, params), context);
    if (elevation) give_elevation(roads, *elevation);
    return roads;
  }

 private:
  mutable RememberRoads memory_;
};

}  // namespace stope::topology

using stope::topology::Skeleton;
STOPE_STAGE(Skeleton, "topology/skeleton")
