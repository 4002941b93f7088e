// Problem: does a truck's rectangle, swept along its way, meet an obstacle cell?
// Idea: a convex outline and a row of cells share an interval of columns; the outline meets a cell
// exactly if the interval does. Far from obstacles covering circles and the clearance field answer,
// and as no point of the outline moves faster than (1 + reach * curvature) times the rear axle, a
// known clearance is driven through without looking.
// Cost: rows of cells under the outline for each look near obstacles, one field lookup a circle
// elsewhere.
#include "plugins/planner/footprint.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace stope::planner {

Footprint::Stand Footprint::stand_along(const Pose2& start, const Heading& heading,
                                        const CurvePiece& piece, double along) {
  if (along == 0) return {{start.x, start.y}, heading};
  if (piece.curvature != piece.curvature_end)
    return stand(advance(start, first_part(piece, along)));
  const double length = std::copysign(along, piece.length), half = length * piece.curvature / 2;
  const Heading turn = Heading::turn(half), middle = heading.turned(turn);
  const double chord = half == 0 ? length : length * turn.sine() / half;
  return {{start.x + chord * middle.cosine(), start.y + chord * middle.sine()},
          middle.turned(turn)};
}

std::optional<Vector2> Footprint::touched(const Stand& stand, double wider) const {
  const GridFrame& frame = grid_.frame;
  const double c = stand.heading.cosine(), s = stand.heading.sine();
  const double ahead = vehicle_.nose() + wider, behind = -vehicle_.rear_overhang - wider;
  const double side = vehicle_.width / 2 + wider;
  std::array<Vector2, 4> corners;
  const std::array<std::pair<double, double>, 4> local{
      {{behind, -side}, {ahead, -side}, {ahead, side}, {behind, side}}};
  double bottom = std::numeric_limits<double>::infinity(), top = -bottom;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto [a, b] = local[i];
    corners[i] = frame.to_grid(stand.at.x() + c * a - s * b, stand.at.y() + s * a + c * b);
    if (!std::isfinite(corners[i].x()) || !std::isfinite(corners[i].y())) return stand.at;
    const bool outside = corners[i].x() < 0 || corners[i].y() < 0 || corners[i].x() > frame.width ||
                         corners[i].y() > frame.height;
    if (outside) return frame.to_map(corners[i].x(), corners[i].y());
    bottom = std::min(bottom, corners[i].y()), top = std::max(top, corners[i].y());
  }
  std::array<double, 4> slopes;  // columns a row; of level edges the ends are all that counts
  for (std::size_t i = 0; i < 4; ++i) {
    const Vector2 way = corners[(i + 1) % 4] - corners[i];
    slopes[i] = way.y() != 0 ? way.x() / way.y() : 0;
  }
  const auto first = static_cast<std::int32_t>(bottom);
  const auto last = std::min(static_cast<std::int32_t>(top), frame.height - 1);
  for (std::int32_t row = first; row <= last; ++row) {
    double left = std::numeric_limits<double>::infinity(), right = -left;
    const auto reach_to = [&](double x) { left = std::min(left, x), right = std::max(right, x); };
    for (std::size_t i = 0; i < 4; ++i) {
      const Vector2 &a = corners[i], &b = corners[(i + 1) % 4];
      if (a.y() >= row && a.y() <= row + 1) reach_to(a.x());
      for (const double line : {double(row), double(row) + 1})
        if ((a.y() < line) != (b.y() < line)) reach_to(a.x() + (line - a.y()) * slopes[i]);
    }
    const auto from = std::max(0, static_cast<std::int32_t>(left));
    const auto to = std::min(static_cast<std::int32_t>(right), frame.width - 1);
    const std::uint8_t* cells = &grid_.cells[frame.place({0, row})];
    // Without a way out in between, so that many cells are looked at in one step.
    std::uint8_t most = 0;
    for (std::int32_t column = from; column <= to; ++column) most = std::max(most, cells[column]);
    if (most < 127) continue;
    for (std::int32_t column = from; column <= to; ++column)
      if (cells[column] >= 127) return frame.centre({column, row});
  }
  return std::nullopt;
}

double Footprint::quick_clearance(const Stand& stand) const {
  const double c = stand.heading.cosine(), s = stand.heading.sine();
  double least = std::numeric_limits<double>::infinity();
  for (const double offset : circles_.offsets)
    least = std::min(least, field_.at_least(stand.at.x() + c * offset, stand.at.y() + s * offset));
  return least - circles_.radius;
}

double Footprint::clearance(const Pose2& pose) const {
  constexpr double kNear = 5;  // metres
  const double quick = quick_clearance(pose);
  if (quick >= kNear) return quick;
  const GridFrame& frame = grid_.frame;
  const double c = std::cos(pose.yaw), s = std::sin(pose.yaw);
  const double middle = vehicle_.length / 2 - vehicle_.rear_overhang;
  const Vector2 centre(pose.x + c * middle, pose.y + s * middle);
  const double around =
      (std::hypot(vehicle_.length, vehicle_.width) / 2 + kNear) / frame.resolution + 1;
  const Vector2 at = frame.to_grid(centre.x(), centre.y());
  double least = std::pow(kNear + frame.resolution, 2);
  const auto from_row = static_cast<std::int32_t>(std::floor(at.y() - around));
  const auto from_column = static_cast<std::int32_t>(std::floor(at.x() - around));
  const auto to_row = static_cast<std::int32_t>(std::floor(at.y() + around));
  const auto to_column = static_cast<std::int32_t>(std::floor(at.x() + around));
  for (std::int32_t row = from_row; row <= to_row; ++row) {
    const bool on_map = row >= 0 && row < frame.height;
    const std::uint8_t* cells = on_map ? &grid_.cells[frame.place({0, row})] : nullptr;
    for (std::int32_t column = from_column; column <= to_column; ++column) {
      if (on_map && column >= 0 && column < frame.width && cells[column] < 127) continue;
      const Vector2 away = frame.centre({column, row}) - centre;
      const double beyond_end =
          std::max(0.0, std::abs(c * away.x() + s * away.y()) - vehicle_.length / 2);
      const double beyond_side =
          std::max(0.0, std::abs(-s * away.x() + c * away.y()) - vehicle_.width / 2);
      least = std::min(least, beyond_end * beyond_end + beyond_side * beyond_side);
    }
  }
  return std::max(0.0, std::sqrt(least) - frame.resolution * std::numbers::sqrt2 / 2);
}

std::optional<Footprint::Touch> Footprint::first_touch(const DriveCurve& curve) const {
  constexpr double kWider = kBetween / 2;
  Pose2 start = curve.start;
  double driven = 0;
  if (curve.pieces.empty()) {
    const auto cell = touched(start, vehicle_.margin + kWider);
    return cell ? std::optional(Touch{0, start, *cell}) : std::nullopt;
  }
  for (const CurvePiece& piece : curve.pieces) {
    const double length = std::abs(piece.length);
    const double speed =
        1 + vehicle_.reach() * std::max(std::abs(piece.curvature), std::abs(piece.curvature_end));
    const Heading heading(start.yaw);
    for (double along = 0;;) {
      const Stand here = stand_along(start, heading, piece, along);
      double step = (quick_clearance(here) - vehicle_.margin) / speed;
      if (step < kBetween / speed) {
        if (const auto cell = touched(here, vehicle_.margin + kWider))
          return Touch{driven + along, along > 0 ? advance(start, first_part(piece, along)) : start,
                       *cell};
        step = kBetween / speed;
      }
      if (along >= length) break;
      along = std::min(length, along + step);
    }
    start = advance(start, piece);
    driven += length;
  }
  return std::nullopt;
}

}  // namespace stope::planner
