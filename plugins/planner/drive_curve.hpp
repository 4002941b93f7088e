#pragma once

#include <vector>

#include "stope/geometry.hpp"

namespace stope::planner {

/// A piece of a truck's way along which curvature changes evenly: a straight, an arc or a piece of
/// a clothoid.
struct CurvePiece {
  double length = 0;                        ///< metres; negative: driven backwards
  double curvature = 0, curvature_end = 0;  ///< 1/m, positive with the wheels to the left
};

/// Where the truck is after driving a piece.
Pose2 advance(const Pose2& from, const CurvePiece& piece);
/// The first `distance` metres (not negative) of a piece.
CurvePiece first_part(const CurvePiece& piece, double distance);
/// What is left of a piece after `distance` metres.
CurvePiece last_part(const CurvePiece& piece, double distance);

/// A way to drive: a pose and the pieces driven from there. Position and heading are continuous by
/// construction.
struct DriveCurve {
  Pose2 start;
  std::vector<CurvePiece> pieces;
  double length() const;
  Pose2 end() const;
};

/// The part of a curve between two distances along it.
DriveCurve part_of(const DriveCurve& curve, double from, double to);
void append(DriveCurve& curve, const DriveCurve& more);

/// A place on a curve.
struct CurvePlace {
  double along = 0;  ///< metres driven since the start
  Pose2 pose;
  double curvature = 0;
  bool backwards = false;
};

/// Places along a curve, no farther apart than `step`; the ends of every piece are among them.
std::vector<CurvePlace> places_along(const DriveCurve& curve, double step);

}  // namespace stope::planner
