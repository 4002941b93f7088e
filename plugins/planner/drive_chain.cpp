// Problem: an optimizer drives the same kilometre some hundred times and asks for sines each time.
// Idea: a piece of a metre turns the heading by little, so the headings along it follow from the
// one before it by a short series, and Gauss and Legendre's rule with three nodes (as in
// drive_curve.cpp) gives the position. Cost: two transcendental functions a piece.
#include "plugins/planner/drive_chain.hpp"

#include <algorithm>

namespace stope::planner {
namespace {

DriveState driven(const DriveState& from, const Heading& heading, const DriveControl& control) {
  constexpr double kNodes[3] = {0.11270166537925831, 0.5, 0.88729833462074169};
  constexpr double kWeights[3] = {5.0 / 18, 8.0 / 18, 5.0 / 18};
  const double length = control[1], rise = control[0] * length;
  double dx = 0, dy = 0;
  for (int i = 0; i < 3; ++i) {
    const Heading there = heading.turned(length * kNodes[i] * (from[3] + 0.5 * rise * kNodes[i]));
    dx += kWeights[i] * there.cosine();
    dy += kWeights[i] * there.sine();
  }
  return {from[0] + length * dx, from[1] + length * dy, from[2] + length * (from[3] + 0.5 * rise),
          from[3] + rise};
}

}  // namespace

Drive::Drive(const DriveState& start, std::size_t pieces) {
  states.reserve(pieces + 1);
  headings.reserve(pieces + 1);
  controls.reserve(pieces);
  states.push_back(start);
  headings.emplace_back(start[2]);
}

void Drive::go_on(const DriveControl& control) {
  states.push_back(driven(states.back(), headings.back(), control));
  headings.emplace_back(states.back()[2]);
  controls.push_back(control);
}

DriveCurve Drive::curve() const {
  const DriveState& start = states.front();
  DriveCurve curve{{start[0], start[1], start[2]}, {}};
  for (std::size_t k = 0; k < controls.size(); ++k)
    curve.pieces.push_back({controls[k][1], states[k][3], states[k + 1][3]});
  return curve;
}

DriveSlopes slopes_of(const Drive& drive, std::size_t piece) {
  const DriveState& state = drive.states[piece];
  const double rate = drive.controls[piece][0], length = drive.controls[piece][1];
  const double square = length * length, cube = square * length;
  const Heading mean = drive.headings[piece].turned(state[3] * length / 2 + rate * square / 6);
  const double c = mean.cosine(), s = mean.sine();
  const Heading& end = drive.headings[piece + 1];
  DriveSlopes slopes;
  auto& a = slopes.state;
  a.setIdentity();
  a(0, 2) = -length * s, a(1, 2) = length * c;
  a(0, 3) = -square / 2 * s, a(1, 3) = square / 2 * c, a(2, 3) = length;
  auto& b = slopes.control;
  b(0, 0) = -cube / 6 * s, b(1, 0) = cube / 6 * c, b(2, 0) = square / 2, b(3, 0) = length;
  b(0, 1) = end.cosine(), b(1, 1) = end.sine(), b(2, 1) = state[3] + rate * length, b(3, 1) = rate;
  return slopes;
}

DriveControl DriveLimits::limited(const DriveState& state, DriveControl control) const {
  control[1] = std::clamp(control[1], 0.4 * even, 1.8 * even);
  control[0] = std::clamp(control[0], -most_rate, most_rate);
  control[0] = std::clamp(control[0], (-most_curvature - state[3]) / control[1],
                          (most_curvature - state[3]) / control[1]);
  return control;
}

DriveLimits::Held DriveLimits::held(const DriveControl& control, const DriveState& next,
                                    const DriveControl& wish) const {
  constexpr double kAt = 1e-9;
  const auto pushes = [&](double value, double low, double high, double by) {
    return (value >= high - kAt && by > 0) || (value <= low + kAt && by < 0);
  };
  return {pushes(control[0], -most_rate, most_rate, wish[0]),
          pushes(next[3], -most_curvature, most_curvature, wish[0]),
          pushes(control[1], 0.4 * even, 1.8 * even, wish[1])};
}

}  // namespace stope::planner
