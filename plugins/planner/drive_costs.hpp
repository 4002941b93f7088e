#pragma once

#include "plugins/planner/clearance_field.hpp"
#include "plugins/planner/curve_optimizer.hpp"
#include "plugins/planner/drive_chain.hpp"
#include "plugins/planner/route_line.hpp"

namespace stope::planner {

/// What a drive costs, in metres of straight driving, and how that changes with each of its states
/// and controls; second derivatives as Gauss and Newton approximate them. Costs of the state k are
/// those of its place, of the last state also those of missing the goal.
class DriveCosts {
 public:
  DriveCosts(const RouteLine& line, const Vehicle& vehicle, const ClearanceField& field,
             const CurveRequest& request, const CurveWishes& wishes, const DriveLimits& limits)
      : line_(line),
        circles_(vehicle),
        margin_(vehicle.margin),
        field_(field),
        request_(request),
        wishes_(wishes),
        limits_(limits) {}

  /// Writes a drive's feet and its cost.
  void weigh(Drive& drive) const;

  struct OfState {
    DriveState slope = DriveState::Zero();
    Eigen::Matrix<double, 4, 4> bend = Eigen::Matrix<double, 4, 4>::Zero();
    void add(double weight, double value, const DriveState& gradient) {
      slope += 2 * weight * value * gradient;
      bend += 2 * weight * gradient * gradient.transpose();
    }
  };
  /// Of a drive that was weighed.
  OfState of_state(const Drive& drive, std::size_t k) const;

  struct OfControl {
    DriveControl slope, bend;  ///< the two do not mix
  };
  OfControl of_control(const DriveControl& control) const;

 private:
  template <class Add>
  void place_squares(const DriveState& state, const Heading& heading, const Add& add) const;
  template <class Add>
  void goal_squares(const DriveState& state, const Add& add) const;
  double foot_of(const DriveState& state, double from) const;
  double off_line(const DriveState& state, double foot, DriveState& gradient) const;

  const RouteLine& line_;
  const CoveringCircles circles_;
  const double margin_;
  const ClearanceField& field_;
  const CurveRequest& request_;
  const CurveWishes& wishes_;
  const DriveLimits& limits_;
};

}  // namespace stope::planner
