#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "plugins/planner/drive_curve.hpp"
#include "plugins/planner/heading.hpp"

namespace stope::planner {

using DriveState = Eigen::Matrix<double, 4, 1>;    ///< x, y, yaw, curvature
using DriveControl = Eigen::Matrix<double, 2, 1>;  ///< change of curvature by the metre, length

/// A way as a chain of clothoid pieces, as it is driven: one state more than controls.
struct Drive {
  std::vector<DriveState> states;
  std::vector<Heading> headings;  ///< of the states
  std::vector<DriveControl> controls;
  std::vector<double> feet;  ///< of the states: how far along the line the nearest place is
  double cost = std::numeric_limits<double>::infinity();

  Drive(const DriveState& start, std::size_t pieces);
  /// Drives one piece more.
  void go_on(const DriveControl& control);
  DriveCurve curve() const;
};

/// How the state after a piece changes with the one before it and with the control.
struct DriveSlopes {
  Eigen::Matrix<double, 4, 4> state;
  Eigen::Matrix<double, 4, 2> control;
};
DriveSlopes slopes_of(const Drive& drive, std::size_t piece);

/// What a truck can do in a piece.
struct DriveLimits {
  double even = 1;            ///< metres, of a piece; at least 0.4 and at most 1.8 times that
  double most_rate = 1;       ///< change of curvature, 1/m²
  double most_curvature = 1;  ///< 1/m

  DriveControl limited(const DriveState& state, DriveControl control) const;
  /// Which limits a piece stands at and pushes on against, if its control is to change by `wish`.
  struct Held {
    bool rate, lock, length;
  };
  Held held(const DriveControl& control, const DriveState& next, const DriveControl& wish) const;
};

}  // namespace stope::planner
