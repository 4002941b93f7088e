#pragma once

#include <optional>
#include <string>

#include "plugins/planner/footprint.hpp"
#include "stope/payloads/elevation_grid.hpp"

namespace stope::planner {

/// Height of the ground between the centres of an elevation grid's cells, linear in x and y; none
/// where one of the four is not known or off the grid.
std::optional<double> height_at(const ElevationGrid& elevation, double x, double y);

/// Why a curve cannot be driven, and where.
struct Obstruction {
  enum class Kind : int { kTurn, kFootprint, kGrade, kNoElevation } kind = Kind::kTurn;
  double along = 0;  ///< metres driven
  Pose2 pose;
  double value = 0;                    ///< radius in metres, or grade
  Vector2 obstacle = Vector2::Zero();  ///< of kFootprint
};

/// What a truck may drive: a grid's free cells under its swept outline, no bend too tight, no slope
/// too steep. Keeps references.
class Drivability {
 public:
  Drivability(const Vehicle& vehicle, const OccupancyGrid& grid, const ClearanceField& field,
              const ElevationGrid* elevation)
      : vehicle_(vehicle), footprint_(vehicle, grid, field), elevation_(elevation) {}

  /// The first obstruction along a curve, or `any` of them; none: it can be driven.
  std::optional<Obstruction> first_obstruction(const DriveCurve& curve, bool any = false) const;
  bool drivable(const DriveCurve& curve) const { return !first_obstruction(curve, true); }
  /// Of a truck that stands.
  std::optional<Obstruction> obstruction_at(const Pose2& pose) const {
    return first_obstruction({pose, {}});
  }
  /// Rise over run from the rear to the front axle; none without elevation or where it is unknown.
  std::optional<double> grade(const Footprint::Stand& stand) const;
  const Footprint& footprint() const { return footprint_; }
  const Vehicle& vehicle() const { return vehicle_; }

  static constexpr double kLook = 0.1;             ///< metres between two looks at the grade
  static constexpr double kGradeReserve = 0.0005;  ///< for what lies between two looks

 private:
  std::optional<Obstruction> first_slope(const DriveCurve& curve) const;

  const Vehicle vehicle_;
  const Footprint footprint_;
  const ElevationGrid* elevation_;
};

}  // namespace stope::planner
