// Problem: what is a good drive?
// Idea: a sum of squares, each a wish: keep clear of walls (circles that cover the truck, looked up
// in the clearance field), bend and steer little, stay near the line, end at the goal; pieces stay
// about even. Cost: five lookups a state, and the foot on the line looked for near the last one.
#include "plugins/planner/drive_costs.hpp"

#include <algorithm>
#include <cmath>

namespace stope::planner {
namespace {

constexpr double kGoalWeight = 300, kGoalHeadingWeight = 3000, kCurvatureWeight = 2e5;
constexpr double kUneven = 0.5;  // a metre's piece that is a metre longer than its fellows

}  // namespace

/// Calls `add(weight, value, gradient)` for every square that a state's place costs for each metre.
template <class Add>
void DriveCosts::place_squares(const DriveState& state, const Heading& heading,
                               const Add& add) const {
  const double c = heading.cosine(), s = heading.sine();
  const double wanted = circles_.radius + margin_;
  for (const double offset : circles_.offsets) {
    const auto [distance, slope] = field_.at(state[0] + c * offset, state[1] + s * offset);
    const double lack = wanted + 0.1 - distance;
    const double discomfort = wanted + wishes_.comfortable_clearance - distance;
    if (lack <= 0 && discomfort <= 0) continue;
    const DriveState gradient{-slope.x(), -slope.y(), -offset * (-s * slope.x() + c * slope.y()),
                              0};
    if (lack > 0) add(request_.obstacle_weight, lack, gradient);
    if (discomfort > 0) add(wishes_.near_wall, discomfort, gradient);
  }
  add(wishes_.bend, state[3], DriveState(0, 0, 0, 1));
  if (const double over = std::abs(state[3]) - 0.97 * limits_.most_curvature; over > 0)
    add(kCurvatureWeight, over, DriveState(0, 0, 0, state[3] > 0 ? 1 : -1));
}

template <class Add>
void DriveCosts::goal_squares(const DriveState& state, const Add& add) const {
  add(kGoalWeight, state[0] - request_.goal.x(), DriveState(1, 0, 0, 0));
  add(kGoalWeight, state[1] - request_.goal.y(), DriveState(0, 1, 0, 0));
  if (request_.goal_heading) {
    add(kGoalHeadingWeight, std::remainder(state[2] - *request_.goal_heading, 2 * M_PI),
        DriveState(0, 0, 1, 0));
  }
}

/// The line's nearest place to a state, looked for around the last one's.
double DriveCosts::foot_of(const DriveState& state, double from) const {
  constexpr double kBack = 3, kOn = 12;  // metres; with less of it drives cut corners more
  return line_.nearest({state[0], state[1]}, std::max(0.0, from - kBack),
                       std::min(line_.length(), from + kOn));
}

/// Distance from the line, and its gradient.
double DriveCosts::off_line(const DriveState& state, double foot, DriveState& gradient) const {
  constexpr double kFar = 6;  // metres: beyond it the line pulls no stronger
  const Vector2 away = Vector2(state[0], state[1]) - line_.at(foot);
  const double distance = away.norm();
  gradient.setZero();
  if (distance < 1e-9) return 0;
  gradient.head<2>() = away / distance * std::min(1.0, kFar / distance);
  return std::min(distance, kFar);
}

void DriveCosts::weigh(Drive& drive) const {
  double cost = 0, foot = 0;
  DriveState gradient;
  drive.feet.resize(drive.states.size());
  const auto add = [&](double weight, double value, const DriveState&) {
    cost += limits_.even * weight * value * value;
  };
  for (std::size_t k = 0; k < drive.states.size(); ++k) {
    foot = drive.feet[k] = foot_of(drive.states[k], foot);
    place_squares(drive.states[k], drive.headings[k], add);
    add(wishes_.off_line, off_line(drive.states[k], foot, gradient), gradient);
  }
  for (const DriveControl& control : drive.controls) {
    const double uneven = control[1] - limits_.even;
    cost += wishes_.steer * control[0] * control[0] * limits_.even + control[1] +
            kUneven * uneven * uneven / limits_.even;
  }
  goal_squares(drive.states.back(), [&](double weight, double value, const DriveState&) {
    cost += weight * value * value;
  });
  drive.cost = cost;
}

DriveCosts::OfState DriveCosts::of_state(const Drive& drive, std::size_t k) const {
  OfState costs;
  const auto add = [&](double weight, double value, const DriveState& gradient) {
    costs.add(limits_.even * weight, value, gradient);
  };
  place_squares(drive.states[k], drive.headings[k], add);
  DriveState gradient;
  const double off = off_line(drive.states[k], drive.feet[k], gradient);
  add(wishes_.off_line, off, gradient);
  if (k + 1 == drive.states.size()) {
    goal_squares(drive.states[k], [&](double weight, double value, const DriveState& along) {
      costs.add(weight, value, along);
    });
  }
  return costs;
}

DriveCosts::OfControl DriveCosts::of_control(const DriveControl& control) const {
  const double steer = 2 * wishes_.steer * limits_.even, uneven = 2 * kUneven / limits_.even;
  return {{steer * control[0], 1 + uneven * (control[1] - limits_.even)}, {steer, uneven}};
}

}  // namespace stope::planner
