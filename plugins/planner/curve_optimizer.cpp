// Problem: of all ways a truck can drive along a route, the smoothest that keeps clear of walls.
// Idea: the way is a chain of clothoid pieces, so that the truck's limits are limits of two numbers
// a piece, its change of curvature and its length. Iterative LQR (Li and Todorov 2004) with limited
// controls (Tassa, Mansard and Todorov 2014) improves them: backwards along the chain the best
// answer to small deviations, forwards the drive that follows it. Every drive it ever makes obeys
// the limits exactly, because it is driven and not fitted. Cost: O(pieces) a round, some tens of
// rounds.
#include "plugins/planner/curve_optimizer.hpp"

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <utility>

#include "plugins/planner/drive_costs.hpp"

namespace stope::planner {
namespace {

using StateMatrix = Eigen::Matrix<double, 4, 4>;
using ControlMatrix = Eigen::Matrix<double, 2, 2>;
using Mixed = Eigen::Matrix<double, 2, 4>;

DriveLimits limits_of(const Vehicle& vehicle, const DriveCurve& curve) {
  DriveLimits limits;
  limits.even = curve.length() / static_cast<double>(curve.pieces.size());
  limits.most_curvature = vehicle.max_curvature() * (1 - 1e-6);
  limits.most_rate =
      std::min(vehicle.max_curvature_rate(), 2 * limits.most_curvature / limits.even);
  return limits;
}

class Optimizer {
 public:
  Optimizer(const DriveLimits& limits, const DriveCosts& costs, const CurveRequest& request)
      : limits_(limits), costs_(costs), request_(request) {}

  DriveCurve run(const DriveCurve& first, int most_rounds,
                 const std::function<void()>& checkpoint) {
    Drive drive = drive_of(first);
    double damping = 1e-3;
    for (int round = 0; round < most_rounds; ++round) {
      checkpoint();
      if (!backward(drive, damping)) {
        damping = std::max(1e-4, damping * 10);
        continue;
      }
      bool better = false;
      for (double share = 1; share > 0.02 && !better; share /= 2) {
        Drive next = forward(drive, share);
        if (next.cost < drive.cost) {
          const double gain = drive.cost - next.cost;
          const bool done = gain < 1e-5 * drive.cost;
          drive = std::move(next);
          better = true;
          damping = std::max(1e-8, damping / 5);
          if (done) return drive.curve();
        }
      }
      if (better) continue;
      damping = std::max(1e-4, damping * 10);
      if (damping > 1e6) break;
    }
    return drive.curve();
  }

 private:
  Drive drive_of(const DriveCurve& first) const {
    Drive drive({first.start.x, first.start.y, first.start.yaw, first.pieces[0].curvature},
                first.pieces.size());
    for (const CurvePiece& piece : first.pieces) {
      drive.go_on(
          limits_.limited(drive.states.back(),
                          {(piece.curvature_end - piece.curvature) / piece.length, piece.length}));
    }
    costs_.weigh(drive);
    return drive;
  }

  /// Gains for every piece and the wish at the start; false if the damping is too weak.
  bool backward(const Drive& drive, double damping) {
    const std::size_t count = drive.controls.size();
    feedforward_.resize(count);
    feedback_.resize(count);
    DriveCosts::OfState last = costs_.of_state(drive, count);
    DriveState vx = last.slope;
    StateMatrix vxx = last.bend;
    for (std::size_t k = count; k-- > 0;) {
      const auto [a, b] = slopes_of(drive, k);
      const DriveCosts::OfState here = costs_.of_state(drive, k);
      const DriveCosts::OfControl control = costs_.of_control(drive.controls[k]);
      const DriveState qx = here.slope + a.transpose() * vx;
      const StateMatrix va = vxx * a;
      const StateMatrix qxx = here.bend + a.transpose() * va;
      const DriveControl qu = b.transpose() * vx + control.slope;
      ControlMatrix quu = b.transpose() * vxx * b;
      quu.diagonal() += control.bend * (1 + damping);
      const Mixed qux = b.transpose() * va;
      if (!solve(drive, k, qu, quu, qux)) return false;
      const DriveControl& f = feedforward_[k];
      const Mixed& g = feedback_[k];
      vx = qx + g.transpose() * (quu * f + qu) + qux.transpose() * f;
      const StateMatrix raw =
          qxx + g.transpose() * quu * g + g.transpose() * qux + qux.transpose() * g;
      vxx = 0.5 * (raw + raw.transpose());
      if (!vxx.allFinite()) return false;
    }
    start_ = DriveState::Zero();
    if (request_.start_curvature_held) return true;
    start_[3] = -vx[3] / (vxx(3, 3) + 1e-6 + damping);
    if (request_.free_heading) {
      const Eigen::Matrix2d hessian =
          vxx.bottomRightCorner<2, 2>() + (1e-6 + damping) * Eigen::Matrix2d::Identity();
      start_.tail<2>() = -hessian.ldlt().solve(vx.tail<2>());
    }
    return start_.allFinite();
  }

  /// The best change of one control, its limits kept where it stands at one and pushes on.
  bool solve(const Drive& drive, std::size_t k, const DriveControl& qu, const ControlMatrix& quu,
             const Mixed& qux) {
    const double determinant = quu(0, 0) * quu(1, 1) - quu(0, 1) * quu(1, 0);
    if (!(quu(0, 0) > 0 && determinant > 1e-12 * quu(0, 0) * std::abs(quu(1, 1)))) return false;
    const ControlMatrix inverse = quu.inverse();
    const DriveControl wish = -inverse * qu;
    const DriveLimits::Held held = limits_.held(drive.controls[k], drive.states[k + 1], wish);
    DriveControl& f = feedforward_[k];
    Mixed& g = feedback_[k];
    if (!held.rate && !held.lock && !held.length) {
      f = wish;
      g = -inverse * qux;
      return true;
    }
    f.setZero();
    g.setZero();
    if (!held.length) {
      f[1] = -qu[1] / quu(1, 1);
      g.row(1) = -qux.row(1) / quu(1, 1);
    } else if (!held.rate && !held.lock) {
      f[0] = -qu[0] / quu(0, 0);
      g.row(0) = -qux.row(0) / quu(0, 0);
    }
    if (held.lock) g(0, 3) = -1 / drive.controls[k][1];
    return true;
  }

  Drive forward(const Drive& old, double share) const {
    DriveState start = old.states.front() + share * start_;
    start[3] = std::clamp(start[3], -limits_.most_curvature, limits_.most_curvature);
    Drive drive(start, old.controls.size());
    for (std::size_t k = 0; k < old.controls.size(); ++k) {
      const DriveState off = drive.states[k] - old.states[k];
      drive.go_on(limits_.limited(
          drive.states[k],
          DriveControl(old.controls[k] + share * feedforward_[k] + feedback_[k] * off)));
      if (!drive.states.back().allFinite()) return drive;
    }
    costs_.weigh(drive);
    return drive;
  }

  const DriveLimits& limits_;
  const DriveCosts& costs_;
  const CurveRequest& request_;
  std::vector<DriveControl> feedforward_;
  std::vector<Mixed> feedback_;
  DriveState start_ = DriveState::Zero();
};

}  // namespace

DriveCurve optimize_curve(const DriveCurve& first, const RouteLine& line, const Vehicle& vehicle,
                          const ClearanceField& field, const CurveRequest& request,
                          const CurveWishes& wishes, const std::function<void()>& checkpoint) {
  if (first.pieces.empty()) return first;
  const DriveLimits limits = limits_of(vehicle, first);
  const DriveCosts costs(line, vehicle, field, request, wishes, limits);
  return Optimizer(limits, costs, request).run(first, request.most_rounds, checkpoint);
}

}  // namespace stope::planner
