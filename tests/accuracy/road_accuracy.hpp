#pragma once

#include "stope/payloads/road_graph.hpp"

namespace stope::testing {

/// How the "in roads" part of a graph is chosen: places where the true midline is not the true
/// centre line are left out.
struct AccuracyRules {
  double tolerance = 1.0;  ///< metres to the true centre line
  double junction_margin =
      1.0;  ///< road widths around a true junction that count as junction, not as road
  double dead_end_margin =
      1.5;  ///< road widths around a true dead end that count as turning place, not as road
  double dead_end_tolerance = 1.0;  ///< road widths between a true dead end and a found one
};

/// A road graph held against the true one.
struct RoadAccuracy {
  double length_in_roads =
      0;  ///< metres of the graph on a true road, away from junctions and dead ends
  double length_near = 0;        ///< of that, within the tolerance of the true centre line
  double true_length = 0;        ///< metres of true road, away from junctions and dead ends
  double true_length_found = 0;  ///< of that, with the graph within the tolerance
  std::size_t dead_ends = 0;     ///< true ones
  std::size_t dead_ends_found = 0;
  std::size_t spurs = 0;  ///< dead ends of the graph that are near no true one
  long cycles = 0, true_cycles = 0;
  double correctness() const { return length_in_roads > 0 ? length_near / length_in_roads : 0; }
  double completeness() const { return true_length > 0 ? true_length_found / true_length : 0; }
  double dead_end_recall() const {
    return dead_ends > 0 ? static_cast<double>(dead_ends_found) / static_cast<double>(dead_ends)
                         : 1;
  }
};

/// Samples both graphs every half metre (buffer measure; see docs/results.md for the definitions).
RoadAccuracy measure_roads(const RoadGraph& found, const RoadGraph& truth,
                           const AccuracyRules& rules = {});

/// Independent cycles of a graph: edges - nodes + components.
long cycles(const RoadGraph& graph);

}  // namespace stope::testing
