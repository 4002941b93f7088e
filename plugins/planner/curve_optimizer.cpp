// Problem: of all ways a truck can drive along a route, the smoothest that keeps clear of walls.
// Idea: the way is a chain of clothoid pieces, so that the truck's limits are limits of two numbers
// a piece, its change of curvature and its length. Iterative LQR (Li and Todorov 2004) with limited
// controls (Tassa, Mansard and Todorov 2014) improves them: backwards along the chain the best
// answer to small deviations, forwards the drive that follows it. Every drive it ever makes obeys
// the limits exactly, because it is driven and not fitted. Cost: O(pieces) a round, some tens of
// rounds.
#include "plugins/planner/curve_optimizer.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace stope::planner {
namespace {

using State = Eigen::Matrix<double, 4, 1>;    // x, y, yaw, curvature
using Control = Eigen::Matrix<double, 2, 1>;  // change of curvature by the metre, length
using StateMatrix = Eigen::Matrix<double, 4, 4>;
using ControlMatrix = Eigen::Matrix<double, 2, 2>;
using Mixed = Eigen::Matrix<double, 2, 4>;
using Input = Eigen::Matrix<double, 4, 2>;

constexpr double kGoalWeight = 300, kGoalHeadingWeight = 3000, kCurvatureWeight = 2e5;
constexpr double kUneven = 0.5;  // a metre's piece that is a metre longer than its fellows

State driven(const State& from, const Control& control) {
  const Pose2 pose = advance({from[0], from[1], from[2]},
                             {control[1], from[3], from[3] + control[0] * control[1]});
  return {pose.x, pose.y, pose.yaw, from[3] + control[0] * control[1]};
}

/// A drive: one state more than controls.
struct Drive {
  std::vector<State> states;
  std::vector<Control> controls;
  double cost = std::numeric_limits<double>::infinity();
};

/// Cost of a stage with its derivatives; Gauss and Newton's approximation of the second ones.
struct Expansion {
  State x = State::Zero();
  StateMatrix xx = StateMatrix::Zero();
  Control u = Control::Zero();
  ControlMatrix uu = ControlMatrix::Zero();
  void add(double weight, double value, const State& gradient) {
    x += 2 * weight * value * gradient;
    xx += 2 * weight * gradient * gradient.transpose();
  }
};

class Optimizer {
 public:
  Optimizer(const RouteLine& line, const Vehicle& vehicle, const ClearanceField& field,
            const CurveRequest& request, const CurveWishes& wishes)
      : line_(line),
        vehicle_(vehicle),
        circles_(vehicle),
        field_(field),
        request_(request),
        wishes_(wishes),
        most_curvature_(vehicle.max_curvature() * (1 - 1e-6)) {}

  DriveCurve run(const DriveCurve& first, const std::function<void()>& checkpoint) {
    Drive drive = drive_of(first);
    double damping = 1e-3;
    for (int round = 0; round < request_.most_rounds; ++round) {
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
          if (done) return curve_of(drive);
        }
      }
      if (better) continue;
      damping = std::max(1e-4, damping * 10);
      if (damping > 1e6) break;
    }
    return curve_of(drive);
  }

 private:
  Drive drive_of(const DriveCurve& first) {
    Drive drive;
    const auto count = static_cast<double>(first.pieces.size());
    even_ = first.length() / count;
    rate_ = std::min(vehicle_.max_curvature_rate(), 2 * most_curvature_ / even_);
    drive.states.push_back({first.start.x, first.start.y, first.start.yaw,
                            first.pieces.empty() ? 0 : first.pieces[0].curvature});
    for (const CurvePiece& piece : first.pieces) {
      drive.controls.push_back(
          limited(drive.states.back(),
                  {(piece.curvature_end - piece.curvature) / piece.length, piece.length}));
      drive.states.push_back(driven(drive.states.back(), drive.controls.back()));
    }
    drive.cost = cost_of(drive);
    return drive;
  }

  static DriveCurve curve_of(const Drive& drive) {
    const State& start = drive.states.front();
    DriveCurve curve{{start[0], start[1], start[2]}, {}};
    for (std::size_t k = 0; k < drive.controls.size(); ++k)
      curve.pieces.push_back({drive.controls[k][1], drive.states[k][3], drive.states[k + 1][3]});
    return curve;
  }

  Control limited(const State& state, Control control) const {
    control[1] = std::clamp(control[1], 0.4 * even_, 1.8 * even_);
    control[0] = std::clamp(control[0], -rate_, rate_);
    control[0] = std::clamp(control[0], (-most_curvature_ - state[3]) / control[1],
                            (most_curvature_ - state[3]) / control[1]);
    return control;
  }

  /// Calls `add(weight, value, gradient)` for every square a state costs for each metre.
  template <class Add>
  void state_squares(const State& state, const Add& add) const {
    const double c = std::cos(state[2]), s = std::sin(state[2]);
    for (const double offset : circles_.offsets) {
      const auto [distance, slope] = field_.at(state[0] + c * offset, state[1] + s * offset);
      const double wanted = circles_.radius + vehicle_.margin;
      const State gradient{slope.x(), slope.y(), offset * (-s * slope.x() + c * slope.y()), 0};
      if (const double lack = wanted + 0.1 - distance; lack > 0)
        add(request_.obstacle_weight, lack, State(-gradient));
      if (const double lack = wanted + wishes_.comfortable_clearance - distance; lack > 0)
        add(wishes_.near_wall, lack, State(-gradient));
    }
    add(wishes_.bend, state[3], State(0, 0, 0, 1));
    if (const double over = std::abs(state[3]) - 0.97 * most_curvature_; over > 0)
      add(kCurvatureWeight, over, State(0, 0, 0, state[3] > 0 ? 1 : -1));
  }

  /// Distance from the line, its gradient, and how far along the foot is.
  double off_line(const State& state, double& along, State& gradient) const {
    constexpr double kFar = 6;  // metres: beyond it the line pulls no stronger
    along = line_.nearest({state[0], state[1]}, std::max(0.0, along - 3),
                          std::min(line_.length(), along + 12));
    const Vector2 away = Vector2(state[0], state[1]) - line_.at(along);
    const double distance = away.norm();
    gradient.setZero();
    if (distance < 1e-9) return 0;
    gradient.head<2>() = away / distance * std::min(1.0, kFar / distance);
    return std::min(distance, kFar);
  }

  template <class Add>
  void goal_squares(const State& state, const Add& add) const {
    add(kGoalWeight, state[0] - request_.goal.x(), State(1, 0, 0, 0));
    add(kGoalWeight, state[1] - request_.goal.y(), State(0, 1, 0, 0));
    if (request_.goal_heading) {
      add(kGoalHeadingWeight, std::remainder(state[2] - *request_.goal_heading, 2 * M_PI),
          State(0, 0, 1, 0));
    }
  }

  double control_cost(const Control& control) const {
    const double uneven = control[1] - even_;
    return wishes_.steer * control[0] * control[0] * even_ + control[1] +
           kUneven * uneven * uneven / even_;
  }

  double cost_of(const Drive& drive) const {
    double cost = 0, along = 0;
    State ignored;
    const auto add = [&](double weight, double value, const State&) {
      cost += even_ * weight * value * value;
    };
    for (std::size_t k = 0; k < drive.states.size(); ++k) {
      state_squares(drive.states[k], add);
      add(wishes_.off_line, off_line(drive.states[k], along, ignored), ignored);
      if (k < drive.controls.size()) cost += control_cost(drive.controls[k]);
    }
    goal_squares(drive.states.back(), [&](double weight, double value, const State&) {
      cost += weight * value * value;
    });
    return cost;
  }

  static void linearize(const State& state, const Control& control, StateMatrix& a, Input& b) {
    const double length = control[1], rate = control[0];
    const double yaw = state[2] + state[3] * length / 2 + rate * length * length / 6;
    const double end = state[2] + state[3] * length + rate * length * length / 2;
    const double c = std::cos(yaw), s = std::sin(yaw);
    a.setIdentity();
    a(0, 2) = -length * s, a(1, 2) = length * c;
    a(0, 3) = -length * length / 2 * s, a(1, 3) = length * length / 2 * c, a(2, 3) = length;
    b.setZero();
    b(0, 0) = -length * length * length / 6 * s, b(1, 0) = length * length * length / 6 * c;
    b(2, 0) = length * length / 2, b(3, 0) = length;
    b(0, 1) = std::cos(end), b(1, 1) = std::sin(end);
    b(2, 1) = state[3] + rate * length, b(3, 1) = rate;
  }

  /// Gains for every piece and the wish at the start; false if the damping is too weak.
  bool backward(const Drive& drive, double damping) {
    const std::size_t count = drive.controls.size();
    feedforward_.assign(count, Control::Zero());
    feedback_.assign(count, Mixed::Zero());
    std::vector<Expansion> stages(count + 1);
    double along = 0;
    for (std::size_t k = 0; k <= count; ++k) {
      Expansion& stage = stages[k];
      const auto add = [&](double weight, double value, const State& gradient) {
        stage.add(even_ * weight, value, gradient);
      };
      state_squares(drive.states[k], add);
      State gradient;
      const double off = off_line(drive.states[k], along, gradient);
      add(wishes_.off_line, off, gradient);
    }
    goal_squares(drive.states.back(), [&](double weight, double value, const State& gradient) {
      stages.back().add(weight, value, gradient);
    });
    State vx = stages.back().x;
    StateMatrix vxx = stages.back().xx;
    for (std::size_t k = count; k-- > 0;) {
      const Control& control = drive.controls[k];
      StateMatrix a;
      Input b;
      linearize(drive.states[k], control, a, b);
      const State qx = stages[k].x + a.transpose() * vx;
      const StateMatrix qxx = stages[k].xx + a.transpose() * vxx * a;
      Control qu = b.transpose() * vx;
      qu[0] += 2 * wishes_.steer * even_ * control[0];
      qu[1] += 1 + 2 * kUneven * (control[1] - even_) / even_;
      ControlMatrix quu = b.transpose() * vxx * b;
      quu(0, 0) += (2 * wishes_.steer * even_) * (1 + damping);
      quu(1, 1) += (2 * kUneven / even_) * (1 + damping);
      const Mixed qux = b.transpose() * vxx * a;
      if (!solve(drive.states[k], drive.states[k + 1], control, qu, quu, qux, k)) return false;
      const Control& f = feedforward_[k];
      const Mixed& g = feedback_[k];
      vx = qx + g.transpose() * (quu * f + qu) + qux.transpose() * f;
      const StateMatrix raw =
          qxx + g.transpose() * quu * g + g.transpose() * qux + qux.transpose() * g;
      vxx = 0.5 * (raw + raw.transpose());
      if (!vxx.allFinite()) return false;
    }
    start_ = State::Zero();
    start_[3] = -vx[3] / (vxx(3, 3) + 1e-6 + damping);
    if (request_.free_heading) {
      const Eigen::Matrix2d hessian =
          vxx.bottomRightCorner<2, 2>() + (1e-6 + damping) * Eigen::Matrix2d::Identity();
      start_.tail<2>() = -hessian.ldlt().solve(vx.tail<2>());
    }
    return start_.allFinite();
  }

  /// The best change of one control, its limits kept where it stands at one and pushes on.
  bool solve(const State& state, const State& next, const Control& control, const Control& qu,
             const ControlMatrix& quu, const Mixed& qux, std::size_t k) {
    const double determinant = quu(0, 0) * quu(1, 1) - quu(0, 1) * quu(1, 0);
    if (!(quu(0, 0) > 0 && determinant > 1e-12 * quu(0, 0) * std::abs(quu(1, 1)))) return false;
    const ControlMatrix inverse = quu.inverse();
    const Control wish = -inverse * qu;
    constexpr double kAt = 1e-9;
    const bool steer_held =
        (control[0] >= rate_ - kAt && wish[0] > 0) || (control[0] <= -rate_ + kAt && wish[0] < 0);
    const bool lock_held = (next[3] >= most_curvature_ - kAt && wish[0] > 0) ||
                           (next[3] <= -most_curvature_ + kAt && wish[0] < 0);
    const bool length_held = (control[1] >= 1.8 * even_ - kAt && wish[1] > 0) ||
                             (control[1] <= 0.4 * even_ + kAt && wish[1] < 0);
    Control& f = feedforward_[k];
    Mixed& g = feedback_[k];
    (void)state;
    if (!steer_held && !lock_held && !length_held) {
      f = wish;
      g = -inverse * qux;
    } else if (!length_held) {
      f = {0, -qu[1] / quu(1, 1)};
      g.row(1) = -qux.row(1) / quu(1, 1);
      if (lock_held) g(0, 3) = -1 / control[1];
    } else if (!steer_held && !lock_held) {
      f = {-qu[0] / quu(0, 0), 0};
      g.row(0) = -qux.row(0) / quu(0, 0);
    } else if (lock_held) {
      g(0, 3) = -1 / control[1];
    }
    return true;
  }

  Drive forward(const Drive& old, double share) const {
    Drive drive;
    drive.states.reserve(old.states.size());
    drive.controls.reserve(old.controls.size());
    State start = old.states.front() + share * start_;
    start[3] = std::clamp(start[3], -most_curvature_, most_curvature_);
    drive.states.push_back(start);
    for (std::size_t k = 0; k < old.controls.size(); ++k) {
      const State off = drive.states[k] - old.states[k];
      drive.controls.push_back(
          limited(drive.states[k],
                  Control(old.controls[k] + share * feedforward_[k] + feedback_[k] * off)));
      drive.states.push_back(driven(drive.states[k], drive.controls[k]));
      if (!drive.states.back().allFinite()) return drive;
    }
    drive.cost = cost_of(drive);
    return drive;
  }

  const RouteLine& line_;
  const Vehicle& vehicle_;
  const CoveringCircles circles_;
  const ClearanceField& field_;
  const CurveRequest& request_;
  const CurveWishes& wishes_;
  const double most_curvature_;
  double even_ = 1, rate_ = 1;
  std::vector<Control> feedforward_;
  std::vector<Mixed> feedback_;
  State start_ = State::Zero();
};

}  // namespace

DriveCurve optimize_curve(const DriveCurve& first, const RouteLine& line, const Vehicle& vehicle,
                          const ClearanceField& field, const CurveRequest& request,
                          const CurveWishes& wishes, const std::function<void()>& checkpoint) {
  return Optimizer(line, vehicle, field, request, wishes).run(first, checkpoint);
}

}  // namespace stope::planner
