#pragma once

#include <fmt/format.h>

#include <string>
#include <utility>

#include "plugins/topology/describe_extraction.hpp"
#include "plugins/topology/regions/finish_regions.hpp"

namespace stope::topology {

/// Which roads between regions are kept: what the issue calls `simplify`, a name that the family
/// has for a length.
struct NetworkParams {
  NetworkParams() : network("none") {}  // as a member's initialiser, g++ 12 warns of it wrongly
  std::string network;
  double stretch = 1.5;
};

template <class Stage>
void describe_network(About<Stage>& about) {
  about
      .param(
          "network", &NetworkParams::network, one_of({"none", "mst", "spanner"}),
          "How the network is thinned: not at all, to a spanning tree (mst: no loop is left), or "
          "to a spanner.")
      .param("stretch", &NetworkParams::stretch, at_least(1.0),
             "How much longer a way in the spanner may be than before.");
}

inline RegionRoadsRule roads_rule(const ExtractionParams& params, const NetworkParams& network) {
  RegionRoadsRule rule;
  rule.min_clearance = params.min_clearance;
  rule.tolerance = params.simplify;
  rule.network = network.network == "mst"       ? Network::kSpanningTree
                 : network.network == "spanner" ? Network::kSpanner
                                                : Network::kAll;
  rule.stretch = network.stretch;
  return rule;
}

/// Why regions fall into parts that do not touch, and what to do.
inline std::string why_apart(const RegionsAndRoads& result) {
  if (result.pieces == result.space_pieces) return "because free space does";
  if (result.pieces < result.space_pieces)
    return fmt::format(
        "fewer than the {} pieces of free space that they lie in, because in mode: paper a region "
        "has cells beyond obstacles too",
        result.space_pieces);
  return fmt::format(
      "although free space {}: {:.4f} of the free cells are in no region, and some of them lie "
      "between; raise second_radius (in mode: paper, coverage) to close the gaps",
      result.space_pieces == 1 ? "is one piece"
                               : fmt::format("is {} pieces only", result.space_pieces),
      1 - result.covered);
}

/// Logs what was found. Without any road throws Error unless params.allow_empty. `exact` says that
/// roads lead wherever there is a way from region to region.
inline void report_regions(const RegionsAndRoads& result, const ExtractionParams& params,
                           bool exact, Context& context) {
  const std::size_t count = result.map.regions.size();
  context.info(fmt::format("{} {} {:.4f} of the free cells", count,
                           count == 1 ? "region covers" : "regions cover", result.covered));
  if (result.dropped > 0)
    context.warn(fmt::format(
        "{} of free space, {} cells together, {} left out: smaller than min_region_area, with no "
        "way to it, as noise of the map is; lower min_region_area to keep {}",
        result.dropped == 1 ? "1 part" : fmt::format("{} parts", result.dropped),
        result.dropped_cells, result.dropped == 1 ? "is" : "are",
        result.dropped == 1 ? "it" : "them"));
  if (result.pieces > 1)
    context.warn(fmt::format(
        "the regions fall into {} parts that do not touch, {}. Each part has a graph of its own, "
        "and no road leads from one to another",
        result.pieces, why_apart(result)));
  const std::string why =
      count == 0   ? "there is no region, because none grew; with smaller growth_radius and "
                     "max_radius (in mode: paper, a larger coverage) some may"
      : count == 1 ? "it is one single region, which has nothing to be connected with; smaller "
                     "regions give more, or check the map's resolution"
      : result.neighbours == 0
          ? std::string("no two of its regions touch each other")
          : fmt::format(
                "every way between two regions is narrower than twice min_clearance ({} "
                "m); lower it, or check the map's resolution",
                params.min_clearance);
  std::string apart;  // else as of all members
  if (!exact || result.pieces != result.space_pieces)
    apart = fmt::format(
        "their regions do not touch, or touch or hang together only where it is narrower than "
        "twice min_clearance ({} m)",
        params.min_clearance);
  report_roads(result.roads, params, why, context, std::move(apart));
}

}  // namespace stope::topology
