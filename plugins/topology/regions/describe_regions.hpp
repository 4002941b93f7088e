#pragma once

#include <fmt/format.h>

#include <string>

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

/// Logs what was found. Without any road throws Error unless params.allow_empty.
inline void report_regions(const RegionsAndRoads& result, const ExtractionParams& params,
                           Context& context) {
  const std::size_t count = result.map.regions.size();
  context.info(fmt::format("{} {} cover {:.4f} of the free cells", count,
                           count == 1 ? "region" : "regions", result.covered));
  if (result.dropped > 0)
    context.warn(fmt::format(
        "{} of free space, {} cells together, {} left out as too small for a region of its own: "
        "no way leads there, so it is mostly noise of the map; lower min_region_area to keep {}",
        result.dropped == 1 ? "1 part" : fmt::format("{} parts", result.dropped),
        result.dropped_cells, result.dropped == 1 ? "is" : "are",
        result.dropped == 1 ? "it" : "them"));
  if (result.pieces > 1)
    context.warn(fmt::format(
        "the regions fall into {} parts that do not touch, because free space does: each part has "
        "a graph of its own, and no road leads from one to another",
        result.pieces));
  const std::string why =
      count == 1 ? "it is one single region, which has nothing to be connected with; smaller "
                   "regions give more, or check the map's resolution"
      : result.neighbours == 0
          ? std::string("no two of its regions touch each other")
          : fmt::format(
                "every way between two regions is narrower than twice min_clearance ({} "
                "m); lower it, or check the map's resolution",
                params.min_clearance);
  report_roads(result.roads, params, why, context);
}

}  // namespace stope::topology
