// Problem: how near a line comes to obstacles, exactly, though it passes between cells.
// Idea: only obstacle cells beside free ones matter; runs of them are rectangles in a tree, and the
// distance of a straight piece to a rectangle is had from ends and corners. Cost: O(log n) a piece.
#include "plugins/metric/obstacle_edges.hpp"

#include <algorithm>
#include <cmath>

namespace stope::metric {
namespace {

bool beside_free(const FreeCells& cells, std::int32_t column, std::int32_t row) {
  for (std::int32_t r = row - 1; r <= row + 1; ++r)
    for (std::int32_t c = column - 1; c <= column + 1; ++c)
      if (cells.at(c, r)) return true;
  return false;
}

std::vector<Box> runs_beside_free(const FreeCells& cells) {
  std::vector<Box> boxes;
  for (std::int32_t row = 0; row < cells.frame.height; ++row) {
    std::int32_t begin = -1;
    for (std::int32_t column = 0; column <= cells.frame.width; ++column) {
      const bool edge =
          column < cells.frame.width && !cells.at(column, row) && beside_free(cells, column, row);
      if (edge && begin < 0) begin = column;
      if (edge || begin < 0) continue;
      boxes.push_back({Vector2(begin, row), Vector2(column, row + 1)});
      begin = -1;
    }
  }
  return boxes;
}

double to_piece(const Vector2& a, const Vector2& b, const Vector2& point) {
  const Vector2 span = b - a;
  const double square = span.squaredNorm();
  const double t = square > 0 ? std::clamp((point - a).dot(span) / square, 0.0, 1.0) : 0.0;
  return (a + t * span - point).norm();
}

// Whether the piece has a point inside the box: it does not lie beside it in x, in y, or across
// its own direction.
bool meets(const Vector2& a, const Vector2& b, const Box& box) {
  if (!box_of(a, b).touches(box)) return false;
  const Vector2 across(a.y() - b.y(), b.x() - a.x());
  const Vector2 centre = 0.5 * (box.low + box.high), half = 0.5 * (box.high - box.low);
  return std::abs(across.dot(centre - a)) <=
         std::abs(across.x()) * half.x() + std::abs(across.y()) * half.y();
}

double to_box(const Vector2& a, const Vector2& b, const Box& box) {
  if (meets(a, b, box)) return 0;
  return std::min({box.distance(box_of(a, a)), box.distance(box_of(b, b)), to_piece(a, b, box.low),
                   to_piece(a, b, box.high), to_piece(a, b, {box.low.x(), box.high.y()}),
                   to_piece(a, b, {box.high.x(), box.low.y()})});
}

}  // namespace

ObstacleEdges::ObstacleEdges(const FreeCells& cells)
    : cells_(cells), boxes_(runs_beside_free(cells)), tree_(boxes_) {}

double ObstacleEdges::distance(const Vector2& a, const Vector2& b, double within) const {
  double best = std::numeric_limits<double>::infinity();
  for (const Vector2& end : {a, b}) {
    best = std::min(
        {best, end.x(), end.y(), cells_.frame.width - end.x(), cells_.frame.height - end.y()});
    // On the border between two cells either may be the free one.
    const auto column = static_cast<std::int32_t>(std::floor(end.x()));
    const auto row = static_cast<std::int32_t>(std::floor(end.y()));
    if (best <= 0 || !cells_.at(column, row)) return 0;
  }
  const auto found = tree_.nearest(box_of(a, b), std::min(best, within),
                                   [&](std::uint32_t i) { return to_box(a, b, boxes_[i]); });
  return found ? found->distance : best;
}

}  // namespace stope::metric
