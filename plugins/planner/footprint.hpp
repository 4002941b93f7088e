#pragma once

#include <optional>

#include "plugins/planner/clearance_field.hpp"
#include "plugins/planner/drive_curve.hpp"
#include "plugins/planner/heading.hpp"
#include "plugins/planner/vehicle.hpp"
#include "stope/payloads/occupancy_grid.hpp"

namespace stope::planner {

/// A truck's outline over a grid. Cells of half a chance of an obstacle or more, unknown cells and
/// what lies off the map are obstacles: closed squares. Keeps references to grid and field.
class Footprint {
 public:
  Footprint(const Vehicle& vehicle, const OccupancyGrid& grid, const ClearanceField& field)
      : vehicle_(vehicle), circles_(vehicle), grid_(grid), field_(field) {}

  /// Where the rear axle's middle is, and the heading.
  struct Stand {
    Vector2 at;
    Heading heading;
  };
  static Stand stand(const Pose2& pose) { return {{pose.x, pose.y}, Heading(pose.yaw)}; }
  /// Where the truck is some metres along a piece that begins in a pose: of straights and arcs
  /// without a new sine. `heading` is the pose's.
  static Stand stand_along(const Pose2& start, const Heading& heading, const CurvePiece& piece,
                           double along);

  /// Whether the outline, `wider` metres larger on all sides, meets no obstacle. Exact against the
  /// grid's own cells.
  bool free(const Pose2& pose, double wider) const { return !touched(pose, wider); }
  /// Where it meets one: the obstacle cell's centre; none if it is free.
  std::optional<Vector2> touched(const Pose2& pose, double wider) const {
    return touched(stand(pose), wider);
  }
  /// A lower bound of the distance between outline and obstacles, quickly; off by about a cell of
  /// the field and what the circles jut out over the outline.
  double quick_clearance(const Pose2& pose) const { return quick_clearance(stand(pose)); }

  /// Metres from the outline to the nearest obstacle, never too many: at most 0.71 grid cells too
  /// few up to 5 m, beyond that as quick_clearance().
  double clearance(const Pose2& pose) const;

  struct Touch {
    double along = 0;  ///< metres driven
    Pose2 pose;
    Vector2 obstacle = Vector2::Zero();
  };
  /// The first place where the outline with the vehicle's margin, swept along a curve, meets an
  /// obstacle. Between two looks no point of the outline moves by more than kBetween, and at each
  /// it is widened by half of that: a sweep that is let pass touches nothing, one that is refused
  /// comes within kBetween / 2 of touching.
  std::optional<Touch> first_touch(const DriveCurve& curve) const;
  static constexpr double kBetween = 0.1;  ///< metres

 private:
  std::optional<Vector2> touched(const Stand& stand, double wider) const;
  double quick_clearance(const Stand& stand) const;

  const Vehicle vehicle_;
  const CoveringCircles circles_;
  const OccupancyGrid& grid_;
  const ClearanceField& field_;
};

}  // namespace stope::planner
