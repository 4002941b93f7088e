#pragma once

#include <fmt/format.h>

#include "plugins/topology/extract_roads.hpp"
#include "stope/about.hpp"
#include "stope/context.hpp"

namespace stope::topology {

/// The family's common parameters.
template <class Stage>
void describe_extraction(About<Stage>& about) {
  about
      .param("min_clearance", &ExtractionParams::min_clearance, "m", at_least(0.0),
             "Drops the parts of roads narrower than twice this.")
      .param("min_obstacle_area", &ExtractionParams::min_obstacle_area, "m^2", at_least(0.0),
             "Obstacles (4-connected, with what they enclose) smaller than this count as free.")
      .param("simplify", &ExtractionParams::simplify, "m", at_least(0.0),
             "How far a simplified centre line may be off.")
      .param("occupied_threshold", &ExtractionParams::occupied_threshold, between(0.0, 1.0),
             "Least probability with which a cell is an obstacle.")
      .param("unknown_is_obstacle", &ExtractionParams::unknown_is_obstacle,
             "Whether unknown cells are obstacles; otherwise they are free.");
}

inline void report_roads(const RoadGraph& roads, Context& context) {
  if (roads.edges.empty())
    context.warn(
        "the map has no road that this stage can see; see its notes, min_clearance and "
        "min_obstacle_area");
  else
    context.info(
        fmt::format("{} roads meet or end in {} places", roads.edges.size(), roads.nodes.size()));
}

}  // namespace stope::topology
