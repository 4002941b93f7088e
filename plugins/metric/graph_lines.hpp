#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "plugins/metric/box_tree.hpp"
#include "stope/payloads/road_graph.hpp"

namespace stope::metric {

/// A place on a road: an edge and the metres from its first vertex along its polyline.
struct RoadPlace {
  std::uint32_t edge = 0;
  double along = 0;
};

/// The place of a graph nearest to some point.
struct NearPlace {
  RoadPlace place;
  Vector2 position = Vector2::Zero();  ///< metres, map frame
  double distance = 0;                 ///< metres
};

/// The straight pieces of a graph's roads, seen from above, and where they lie. Elevation is not
/// looked at: all lengths are those of the map.
class GraphLines {
 public:
  struct Piece {
    Vector2 a, b;
    std::uint32_t edge = 0;
    double along = 0;  ///< of `a`, metres from the edge's first vertex
  };

  /// `graph` has passed check_graph().
  explicit GraphLines(const RoadGraph& graph);

  const std::vector<Piece>& pieces() const { return pieces_; }
  std::size_t edge_count() const { return lengths_.size(); }
  double length(std::uint32_t edge) const { return lengths_[edge]; }
  double total_length() const { return total_length_; }
  Vector2 position(RoadPlace place) const;
  /// The place nearest to `point`, if one is at most `within` metres away; of equal ones the first.
  std::optional<NearPlace> nearest(const Vector2& point,
                                   double within = std::numeric_limits<double>::infinity()) const;
  /// Calls visit(piece) for each piece whose bounding box touches `box`.
  template <class Visit>
  void visit_touching(const Box& box, Visit&& visit) const {
    tree_.visit_touching(box, [&](std::uint32_t i) { visit(pieces_[i]); });
  }

 private:
  std::vector<Piece> pieces_;
  std::vector<std::uint32_t> first_piece_;  // of each edge, and one past the last
  std::vector<double> lengths_;
  double total_length_ = 0;
  BoxTree tree_;
};

/// Points of all roads at the middles of equal parts no longer than `step` metres: calls
/// visit(position, length of the part).
template <class Visit>
void visit_samples(const GraphLines& lines, double step, Visit&& visit) {
  for (const GraphLines::Piece& piece : lines.pieces()) {
    const double length = (piece.b - piece.a).norm();
    const double parts = std::ceil(length / step);
    for (double k = 0; k < parts; ++k)
      visit(Vector2(piece.a + (k + 0.5) / parts * (piece.b - piece.a)), length / parts);
  }
}

}  // namespace stope::metric
