#pragma once

#include <vector>

#include "plugins/metric/box_tree.hpp"
#include "plugins/metric/free_cells.hpp"

namespace stope::metric {

/// Exact distances to obstacles as they are drawn: whole square cells, and all that is outside of
/// the grid. All in cells from the grid's lower-left corner.
class ObstacleEdges {
 public:
  explicit ObstacleEdges(const FreeCells& cells);

  /// The least distance of the straight piece a-b to an obstacle, or some distance above `within`
  /// if it is no less; 0 in obstacles.
  double distance(const Vector2& a, const Vector2& b,
                  double within = std::numeric_limits<double>::infinity()) const;

 private:
  const FreeCells& cells_;
  std::vector<Box> boxes_;  // runs of obstacle cells beside free ones
  BoxTree tree_;
};

}  // namespace stope::metric
