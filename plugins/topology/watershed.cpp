#include <fmt/format.h>

#include <string>

#include "plugins/topology/describe_extraction.hpp"
#include "plugins/topology/remember_roads.hpp"
#include "stope/stope.hpp"

namespace stope::topology {

/// Road graph along the watershed of the distance to obstacles. See docs/topology.md.
class Watershed final : public Map<RoadGraph(OccupancyGrid, Optional<ElevationGrid>)> {
 public:
  struct Params : ExtractionParams, BranchParams, PartParams {
    std::string sites = "obstacles";
  } params;

  static void describe(About<Watershed>& about) {
    about.summary("Road graph along the watershed of the distance to obstacles.")
        .from(
            "Huang, Tian and Xia, Automatic Construction Method of Topological Map of Obstacles "
            "in Mining Area, sec. V; flooding after Meyer 1991, 1994")
        .notes(
            "A watershed line separates two obstacles, so it cannot end in free space: with sites: "
            "obstacles, dead ends (loading faces, dumps) are lost by construction, and free space "
            "without holes has no road at all. With sites: outline_parts an obstacle counts as "
            "several, split where its outline turns towards free space, so that roads between its "
            "parts stay; min_branch and min_branch_share then say which of them are roads.")
        .ports("grid", "elevation", "roads");
    describe_extraction(about);
    describe_branches(about);
    describe_lines(about);
    about
        .param(
            "sites", &Params::sites, one_of({"obstacles", "outline_parts"}),
            "What the lines separate: whole obstacles, or parts of their outlines as well, which "
            "keeps dead ends.")
        .param("corner_angle", &PartParams::corner_angle, "rad", between(0.2, 3.0),
               "outline_parts: by how much an outline must turn towards free space to be split.")
        .param("part_length", &PartParams::part_length, "m", more_than(0.0),
               "outline_parts: within which length it must turn so far; a wide round yard needs "
               "more.");
  }

  RoadGraph apply(const OccupancyGrid& grid, const Optional<ElevationGrid>& elevation,
                  Context& context) const {
    const bool parts = params.sites == "outline_parts";
    const auto kind =
        parts ? ExtractionMethod::Kind::kWatershedParts : ExtractionMethod::Kind::kWatershed;
    RoadGraph roads = memory_.extract(grid, {kind, params, params, {}, params}, context);
    report_roads(roads, params, parts ? why_no_branches(params, params) : why_none(), context);
    if (elevation) give_elevation(roads, *elevation);
    return roads;
  }

 private:
  std::string why_none() const {
    return fmt::format(
        "a watershed separates obstacles, so it needs at least one obstacle or hole inside the "
        "free space that is larger than min_obstacle_area ({} m^2), and ways round it wider than "
        "twice min_clearance ({} m); sites: outline_parts and topology/voronoi also find roads "
        "without "
        "loops",
        params.min_obstacle_area, params.min_clearance);
  }

  mutable RememberRoads memory_;
};

}  // namespace stope::topology

using stope::topology::Watershed;
STOPE_STAGE(Watershed, "topology/watershed")
