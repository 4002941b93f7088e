#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "stope/geometry.hpp"
#include "stope/payloads/road_graph.hpp"

namespace stope::metric {

/// How well found places stand for true ones.
struct PlaceRecall {
  std::size_t truth = 0, found = 0, matched = 0;
  double mean_distance = 0, max_distance = 0;  ///< metres, of matched ones; NaN without any

  /// 1 where there is nothing to find.
  double recall() const;
  /// 1 where nothing was found.
  double precision() const;
  double f1() const;
};

/// The places of nodes whose number of road ends is accepted. A ring's one node has two ends.
std::vector<Vector2> nodes_of_degree(const RoadGraph& graph,
                                     const std::function<bool(std::size_t degree)>& accept);

/// Matches one to one, at most `within` metres apart; see match_points().
PlaceRecall recall_places(const std::vector<Vector2>& truth, const std::vector<Vector2>& found,
                          double within);

}  // namespace stope::metric
