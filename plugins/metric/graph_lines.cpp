#include "plugins/metric/graph_lines.hpp"

#include <algorithm>

namespace stope::metric {
namespace {

double fraction_of_foot(const GraphLines::Piece& piece, const Vector2& point) {
  const Vector2 span = piece.b - piece.a;
  const double square = span.squaredNorm();
  return square > 0 ? std::clamp((point - piece.a).dot(span) / square, 0.0, 1.0) : 0.0;
}

std::vector<Box> boxes_of(const std::vector<GraphLines::Piece>& pieces) {
  std::vector<Box> boxes;
  boxes.reserve(pieces.size());
  for (const auto& piece : pieces) boxes.push_back(box_of(piece.a, piece.b));
  return boxes;
}

std::vector<GraphLines::Piece> pieces_of(const RoadGraph& graph) {
  std::vector<GraphLines::Piece> pieces;
  pieces.reserve(graph.vertices.size());
  for (std::uint32_t e = 0; e < graph.edges.size(); ++e) {
    const auto line = graph.polyline(graph.edges[e]);
    double along = 0;
    for (std::size_t i = 1; i < line.size(); ++i) {
      const Vector2 a(line[i - 1].x, line[i - 1].y), b(line[i].x, line[i].y);
      pieces.push_back({a, b, e, along});
      along += (b - a).norm();
    }
  }
  return pieces;
}

}  // namespace

GraphLines::GraphLines(const RoadGraph& graph)
    : pieces_(pieces_of(graph)), lengths_(graph.edges.size()), tree_(boxes_of(pieces_)) {
  for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
    const Piece& piece = pieces_[i];
    while (first_piece_.size() <= piece.edge) first_piece_.push_back(i);
    lengths_[piece.edge] = piece.along + (piece.b - piece.a).norm();
  }
  first_piece_.push_back(static_cast<std::uint32_t>(pieces_.size()));
  for (const double length : lengths_) total_length_ += length;
}

Vector2 GraphLines::position(RoadPlace place) const {
  const auto begin = pieces_.begin() + first_piece_[place.edge];
  const auto end = pieces_.begin() + first_piece_[place.edge + 1];
  auto after = std::upper_bound(begin, end, place.along, [](double along, const Piece& piece) {
    return along < piece.along;
  });
  const Piece& piece = *(after == begin ? begin : after - 1);
  const double length = (piece.b - piece.a).norm();
  const double fraction =
      length > 0 ? std::clamp((place.along - piece.along) / length, 0.0, 1.0) : 0.0;
  return piece.a + fraction * (piece.b - piece.a);
}

std::optional<NearPlace> GraphLines::nearest(const Vector2& point, double within) const {
  const auto foot = [&](const Piece& piece) {
    return Vector2(piece.a + fraction_of_foot(piece, point) * (piece.b - piece.a));
  };
  const auto found = tree_.nearest(box_of(point, point), within, [&](std::uint32_t i) {
    return (foot(pieces_[i]) - point).norm();
  });
  if (!found) return std::nullopt;
  const Piece& piece = pieces_[found->item];
  const double along = piece.along + fraction_of_foot(piece, point) * (piece.b - piece.a).norm();
  return NearPlace{{piece.edge, along}, foot(piece), found->distance};
}

}  // namespace stope::metric
