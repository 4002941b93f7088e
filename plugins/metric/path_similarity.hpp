#pragma once

#include <cstddef>
#include <functional>

#include "plugins/metric/road_distances.hpp"

namespace stope::metric {

/// A graph with all that is asked of it.
struct MeasuredGraph {
  explicit MeasuredGraph(const RoadGraph& checked)
      : graph(checked), lines(checked), distances(checked, lines) {}
  MeasuredGraph(const MeasuredGraph&) = delete;

  const RoadGraph& graph;
  GraphLines lines;
  RoadDistances distances;
};

struct PathSimilarityRules {
  double spacing = 50;  ///< metres between control points along edges, at most
  double snap = 4;      ///< metres a control point may lie from the other graph
  double min_path = 0;  ///< metres: shorter ways are left out
};

struct PathSimilarity {
  double score = 0;  ///< 1 - mean of min(1, |L - L'| / L)
  std::size_t control_points = 0, snapped = 0;
  std::size_t pairs = 0;    ///< connected in `from`
  std::size_t missing = 0;  ///< of them, not connected in `onto`
};

/// One half of APLS: control points of `from` are its nodes and points that part each edge evenly,
/// no more than `spacing` apart; they are snapped onto the nearest place of `onto`. `checkpoint` is
/// called now and then. Throws Error if there are more than 20 000 control points.
PathSimilarity path_similarity(MeasuredGraph& from, MeasuredGraph& onto,
                               const PathSimilarityRules& rules,
                               const std::function<void()>& checkpoint);

}  // namespace stope::metric
