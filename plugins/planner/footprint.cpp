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

std::optional<Vector2> Footprint::touched(const Pose2& pose, double wider) const {
  const GridFrame& frame = grid_.frame;
  const double c = std::cos(pose.yaw), s = std::sin(pose.yaw);
  const double ahead = vehicle_.nose() + wider, behind = -vehicle_.rear_overhang - wider;
  const double side = vehicle_.width / 2 + wider;
  std::array<Vector2, 4> corners;
  const std::array<std::pair<double, double>, 4> local{
      {{behind, -side}, {ahead, -side}, {ahead, side}, {behind, side}}};
  double bottom = std::numeric_limits<double>::infinity(), top = -bottom;
  for (std::size_t i = 0; i < 4; ++i) {
    const auto [a, b] = local[i];
    corners[i] = frame.to_grid(pose.x + c * a - s * b, pose.y + s * a + c * b);
    if (!std::isfinite(corners[i].x()) || !std::isfinite(corners[i].y()))
      return Vector2(pose.x, pose.y);
    const bool outside = corners[i].x() < 0 || corners[i].y() < 0 || corners[i].x() > frame.width ||
                         corners[i].y() > frame.height;
    if (outside) return frame.to_map(corners[i].x(), corners[i].y());
    bottom = std::min(bottom, corners[i].y()), top = std::max(top, corners[i].y());
  }
  const auto first = static_cast<std::int32_t>(bottom);
  const auto last = std::min(static_cast<std::int32_t>(top), frame.height - 1);
  for (std::int32_t row = first; row <= last; ++row) {
    double left = std::numeric_limits<double>::infinity(), right = -left;
    const auto reach_to = [&](double x) { left = std::min(left, x), right = std::max(right, x); };
    for (std::size_t i = 0; i < 4; ++i) {
      const Vector2 &a = corners[i], &b = corners[(i + 1) % 4];
      if (a.y() >= row && a.y() <= row + 1) reach_to(a.x());
      for (const double line : {double(row), double(row) + 1}) {
        if ((a.y() < line) != (b.y() < line))
          reach_to(a.x() + (line - a.y()) / (b.y() - a.y()) * (b.x() - a.x()));
      }
    }
    const auto from = std::max(0, static_cast<std::int32_t>(left));
    const auto to = std::min(static_cast<std::int32_t>(right), frame.width - 1);
    for (std::int32_t column = from; column <= to; ++column) {
      if (grid_.cells[frame.place({column, row})] >= 127) return frame.centre({column, row});
    }
  }
  return std::nullopt;
}

double Footprint::quick_clearance(const Pose2& pose) const {
  const double c = std::cos(pose.yaw), s = std::sin(pose.yaw);
  double least = std::numeric_limits<double>::infinity();
  for (const double offset : circles_.offsets)
    least = std::min(least, field_.at_least(pose.x + c * offset, pose.y + s * offset));
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
  double least = kNear + frame.resolution;
  for (auto row = static_cast<std::int32_t>(std::floor(at.y() - around)); row <= at.y() + around;
       ++row) {
    for (auto column = static_cast<std::int32_t>(std::floor(at.x() - around));
         column <= at.x() + around; ++column) {
      const Cell cell{column, row};
      if (frame.contains(cell) && grid_.cells[frame.place(cell)] < 127) continue;
      const Vector2 away = frame.centre(cell) - centre;
      const double beyond_end =
          std::max(0.0, std::abs(c * away.x() + s * away.y()) - vehicle_.length / 2);
      const double beyond_side =
          std::max(0.0, std::abs(-s * away.x() + c * away.y()) - vehicle_.width / 2);
      least = std::min(least, std::hypot(beyond_end, beyond_side));
    }
  }
  return std::max(0.0, least - frame.resolution * std::numbers::sqrt2 / 2);
}

std::optional<Footprint::Touch> Footprint::first_touch(const DriveCurve& curve) const {
  Pose2 start = curve.start;
  double driven = 0;
  const auto look = [&](const Pose2& pose, double along) -> std::optional<Touch> {
    if (const auto cell = touched(pose, vehicle_.margin + kBetween / 2))
      return Touch{along, pose, *cell};
    return std::nullopt;
  };
  if (curve.pieces.empty()) return look(start, 0);
  for (const CurvePiece& piece : curve.pieces) {
    const double length = std::abs(piece.length);
    const double speed =
        1 + vehicle_.reach() * std::max(std::abs(piece.curvature), std::abs(piece.curvature_end));
    for (double along = 0;;) {
      const Pose2 pose = along > 0 ? advance(start, first_part(piece, along)) : start;
      double step = (quick_clearance(pose) - vehicle_.margin) / speed;
      if (step < kBetween / speed) {
        if (const auto touch = look(pose, driven + along)) return touch;
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
