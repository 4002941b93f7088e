#include "plugins/planner/drive_curve.hpp"

#include <algorithm>
#include <cmath>

namespace stope::planner {
namespace {

/// One clothoid piece over which the heading changes by little: Gauss and Legendre's rule with
/// three nodes, whose error is of the seventh order.
Pose2 advance_little(const Pose2& from, double length, double k0, double k1) {
  constexpr double kNodes[3] = {0.11270166537925831, 0.5, 0.88729833462074169};
  constexpr double kWeights[3] = {5.0 / 18, 8.0 / 18, 5.0 / 18};
  double dx = 0, dy = 0;
  for (int i = 0; i < 3; ++i) {
    const double t = kNodes[i];
    const double yaw = from.yaw + length * t * (k0 + 0.5 * (k1 - k0) * t);
    dx += kWeights[i] * std::cos(yaw);
    dy += kWeights[i] * std::sin(yaw);
  }
  return {from.x + length * dx, from.y + length * dy, from.yaw + length * 0.5 * (k0 + k1)};
}

/// A straight or an arc, of which only the chord is needed.
Pose2 advance_evenly(const Pose2& from, double length, double curvature) {
  const double turn = length * curvature, half = turn / 2;
  const double chord = half == 0 ? length : length * std::sin(half) / half;
  return {from.x + chord * std::cos(from.yaw + half), from.y + chord * std::sin(from.yaw + half),
          from.yaw + turn};
}

}  // namespace

Pose2 advance(const Pose2& from, const CurvePiece& piece) {
  if (piece.curvature == piece.curvature_end)
    return advance_evenly(from, piece.length, piece.curvature);
  constexpr double kLittle = 0.2;  // radians
  const double turn =
      std::abs(piece.length) * std::max(std::abs(piece.curvature), std::abs(piece.curvature_end));
  const int parts = 1 + static_cast<int>(turn / kLittle);
  Pose2 pose = from;
  for (int i = 0; i < parts; ++i) {
    const double a = static_cast<double>(i) / parts, b = static_cast<double>(i + 1) / parts;
    const double rise = piece.curvature_end - piece.curvature;
    pose = advance_little(pose, piece.length / parts, piece.curvature + a * rise,
                          piece.curvature + b * rise);
  }
  return pose;
}

CurvePiece first_part(const CurvePiece& piece, double distance) {
  const double share = std::clamp(distance / std::abs(piece.length), 0.0, 1.0);
  return {piece.length * share, piece.curvature,
          piece.curvature + share * (piece.curvature_end - piece.curvature)};
}

CurvePiece last_part(const CurvePiece& piece, double distance) {
  const double share = std::clamp(distance / std::abs(piece.length), 0.0, 1.0);
  return {piece.length * (1 - share),
          piece.curvature + share * (piece.curvature_end - piece.curvature), piece.curvature_end};
}

double DriveCurve::length() const {
  double sum = 0;
  for (const CurvePiece& piece : pieces) sum += std::abs(piece.length);
  return sum;
}

Pose2 DriveCurve::end() const {
  Pose2 pose = start;
  for (const CurvePiece& piece : pieces) pose = advance(pose, piece);
  return pose;
}

DriveCurve part_of(const DriveCurve& curve, double from, double to) {
  DriveCurve part{curve.start, {}};
  double along = 0;
  for (const CurvePiece& piece : curve.pieces) {
    const double length = std::abs(piece.length), end = along + length;
    if (end <= from) {
      part.start = advance(part.start, piece);
    } else if (along < to && length > 0) {
      CurvePiece left = piece;
      if (along < from) {
        part.start = advance(part.start, first_part(piece, from - along));
        left = last_part(piece, from - along);
      }
      if (end > to) left = first_part(left, to - std::max(from, along));
      if (left.length != 0) part.pieces.push_back(left);
    }
    along = end;
  }
  return part;
}

void append(DriveCurve& curve, const DriveCurve& more) {
  curve.pieces.insert(curve.pieces.end(), more.pieces.begin(), more.pieces.end());
}

std::vector<CurvePlace> places_along(const DriveCurve& curve, double step) {
  std::vector<CurvePlace> places;
  Pose2 pose = curve.start;
  double along = 0;
  for (const CurvePiece& piece : curve.pieces) {
    const double length = std::abs(piece.length);
    if (length == 0) continue;
    const bool backwards = piece.length < 0;
    if (places.empty()) places.push_back({0, pose, piece.curvature, backwards});
    const auto count = std::max(1.0, std::ceil(length / step - 1e-9));
    for (double i = 1; i <= count; ++i) {
      const CurvePiece part = first_part(piece, length * i / count);
      places.push_back(
          {along + length * i / count, advance(pose, part), part.curvature_end, backwards});
    }
    pose = advance(pose, piece);
    along += length;
  }
  if (places.empty()) places.push_back({0, pose, 0, false});
  return places;
}

}  // namespace stope::planner
