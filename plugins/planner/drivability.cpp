#include "plugins/planner/drivability.hpp"

#include <cmath>

namespace stope::planner {

std::optional<double> height_at(const ElevationGrid& elevation, double x, double y) {
  const GridFrame& frame = elevation.frame;
  const Vector2 at = frame.to_grid(x, y);
  if (!(at.x() >= 0 && at.y() >= 0 && at.x() <= frame.width && at.y() <= frame.height))
    return std::nullopt;
  const double u = std::clamp(at.x() - 0.5, 0.0, frame.width - 1.0);
  const double v = std::clamp(at.y() - 0.5, 0.0, frame.height - 1.0);
  const auto column = static_cast<std::int32_t>(u), row = static_cast<std::int32_t>(v);
  const std::int32_t right = std::min(column + 1, frame.width - 1);
  const std::int32_t above = std::min(row + 1, frame.height - 1);
  const auto cell = [&](std::int32_t c, std::int32_t r) {
    return static_cast<double>(elevation.cells[frame.place({c, r})]);
  };
  const double a = u - column, b = v - row;
  const double height = (1 - b) * ((1 - a) * cell(column, row) + a * cell(right, row)) +
                        b * ((1 - a) * cell(column, above) + a * cell(right, above));
  if (!std::isfinite(height)) return std::nullopt;
  return height;
}

std::optional<double> Drivability::grade(const Footprint::Stand& stand) const {
  if (!elevation_) return std::nullopt;
  const auto rear = height_at(*elevation_, stand.at.x(), stand.at.y());
  const auto front =
      height_at(*elevation_, stand.at.x() + vehicle_.wheelbase * stand.heading.cosine(),
                stand.at.y() + vehicle_.wheelbase * stand.heading.sine());
  if (!rear || !front) return std::nullopt;
  return (*front - *rear) / vehicle_.wheelbase;
}

std::optional<Obstruction> Drivability::first_slope(const DriveCurve& curve) const {
  Pose2 start = curve.start;
  Heading heading(start.yaw);
  double driven = 0;
  const auto look = [&](const CurvePiece& piece, double along) -> std::optional<Obstruction> {
    const auto slope = grade(Footprint::stand_along(start, heading, piece, along));
    const bool known = slope.has_value();
    if (known && std::abs(*slope) <= vehicle_.max_grade - kGradeReserve) return std::nullopt;
    const Pose2 pose = along > 0 ? advance(start, first_part(piece, along)) : start;
    return Obstruction{known ? Obstruction::Kind::kGrade : Obstruction::Kind::kNoElevation,
                       driven + along, pose, slope.value_or(0), Vector2::Zero()};
  };
  if (const auto found = look({}, 0)) return found;
  for (const CurvePiece& piece : curve.pieces) {
    const double length = std::abs(piece.length);
    const auto count = std::ceil(length / kLook);
    for (double i = 1; i <= count; ++i)
      if (const auto found = look(piece, length * i / count)) return found;
    start = advance(start, piece);
    heading = Heading(start.yaw);
    driven += length;
  }
  return std::nullopt;
}

std::optional<Obstruction> Drivability::first_obstruction(const DriveCurve& curve, bool any) const {
  std::optional<Obstruction> first;
  const auto take = [&](const Obstruction& found) {
    if (!first || found.along < first->along) first = found;
  };
  Pose2 pose = curve.start;
  double along = 0;
  for (const CurvePiece& piece : curve.pieces) {
    const double tightest = std::max(std::abs(piece.curvature), std::abs(piece.curvature_end));
    if (tightest > vehicle_.max_curvature() * (1 + 1e-9)) {
      take({Obstruction::Kind::kTurn, along, pose, 1 / tightest, Vector2::Zero()});
      break;
    }
    pose = advance(pose, piece);
    along += std::abs(piece.length);
  }
  if (const auto touch = footprint_.first_touch(curve))
    take({Obstruction::Kind::kFootprint, touch->along, touch->pose, 0, touch->obstacle});
  if (elevation_ && !(any && first)) {
    if (const auto slope = first_slope(curve)) take(*slope);
  }
  return first;
}

}  // namespace stope::planner
