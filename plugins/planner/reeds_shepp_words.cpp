// Problem: the shortest ways of a car that drives both ways between two poses.
// Idea: Reeds and Shepp (1990) proved that one of 48 words of arcs and straights is the shortest.
// They come from nine formulas (8.1 to 8.11 of the paper) by three symmetries: driving the other
// way round in time, mirroring left and right, and reading the word backwards. Signs of the paper's
// formulas are known to be misprinted in places, so every word is driven once and kept only if it
// arrives.
// Cost: constant; some 60 formulas.
#include "plugins/planner/reeds_shepp_words.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>
#include <utility>

namespace stope::planner {
namespace {

constexpr double kPi = std::numbers::pi;

struct Polar {
  double radius, angle;
};
Polar polar(double x, double y) { return {std::sqrt(x * x + y * y), std::atan2(y, x)}; }
double wrapped(double angle) { return angle - 2 * kPi * std::round(angle / (2 * kPi)); }

/// A goal as the formulas see it: where the middle of its left circle and of its right one lie,
/// from the middle of the left circle at the start.
struct View {
  explicit View(const WordGoal& goal)
      : yaw(goal.yaw),
        xi(goal.x + std::sin(yaw)),
        eta(goal.y - 1 - std::cos(yaw)),
        left(polar(goal.x - std::sin(yaw), goal.y - 1 + std::cos(yaw))),
        right(polar(xi, eta)) {}
  double yaw, xi, eta;
  Polar left, right;
};

/// Lengths of a formula's arcs and straight: t, u, v of the paper.
struct Lengths {
  double t, u, v;
};
using Solution = std::optional<Lengths>;

Solution left_straight_left(const View& g) {  // 8.1
  const auto [u, t] = g.left;
  const double v = wrapped(g.yaw - t);
  if (t < -kNoLength || v < -kNoLength) return std::nullopt;
  return Lengths{t, u, v};
}
Solution left_straight_right(const View& g) {  // 8.2
  const auto [far, angle] = g.right;
  if (far * far < 4) return std::nullopt;
  const double u = std::sqrt(far * far - 4);
  const double t = wrapped(angle + std::atan2(2, u)), v = wrapped(t - g.yaw);
  if (t < -kNoLength || v < -kNoLength) return std::nullopt;
  return Lengths{t, u, v};
}
Solution left_right_left(const View& g) {  // 8.3 and 8.4
  const auto [far, angle] = g.left;
  if (far > 4) return std::nullopt;
  const double u = -2 * std::asin(0.25 * far);
  const double t = wrapped(angle + 0.5 * u + kPi), v = wrapped(g.yaw - t + u);
  if (t < -kNoLength || u > kNoLength) return std::nullopt;
  return Lengths{t, u, v};
}

/// The outer arcs of the words of four arcs.
std::pair<double, double> outer_arcs(double u, double v, const View& g) {
  const double delta = wrapped(u - v);
  const double a = std::sin(u) - std::sin(delta), b = std::cos(u) - std::cos(delta) - 1;
  const double first = std::atan2(g.eta * a - g.xi * b, g.xi * a + g.eta * b);
  const double second = 2 * (std::cos(delta) - std::cos(v) - std::cos(u)) + 3;
  const double tau = second < 0 ? wrapped(first + kPi) : wrapped(first);
  return {tau, wrapped(tau - u + v - g.yaw)};
}
Solution four_arcs_inner_opposed(const View& g) {  // 8.7: L+ R+u L-u R-
  const double rho = 0.25 * (2 + g.right.radius);
  if (rho > 1) return std::nullopt;
  const double u = std::acos(rho);
  const auto [t, v] = outer_arcs(u, -u, g);
  if (t < -kNoLength || v > kNoLength) return std::nullopt;
  return Lengths{t, u, v};
}
Solution four_arcs_inner_alike(const View& g) {  // 8.8: L+ R-u L-u R+
  const double rho = (20 - g.right.radius * g.right.radius) / 16;
  if (rho < 0 || rho > 1) return std::nullopt;
  const double u = -std::acos(rho);
  const auto [t, v] = outer_arcs(u, u, g);
  if (t < -kNoLength || v < -kNoLength) return std::nullopt;
  return Lengths{t, u, v};
}
Solution quarter_straight_left(const View& g) {  // 8.9: L+ R-(pi/2) S- L-
  const auto [far, angle] = g.left;
  if (far < 2) return std::nullopt;
  const double r = std::sqrt(far * far - 4), u = 2 - r;
  const double t = wrapped(angle + std::atan2(r, -2)), v = wrapped(g.yaw - kPi / 2 - t);
  if (t < -kNoLength || u > kNoLength || v > kNoLength) return std::nullopt;
  return Lengths{t, u, v};
}
Solution quarter_straight_right(const View& g) {  // 8.10: L+ R-(pi/2) S- R-
  const double far = g.right.radius, t = wrapped(g.right.angle + kPi / 2);
  if (far < 2) return std::nullopt;
  const double u = 2 - far, v = wrapped(t + kPi / 2 - g.yaw);
  if (t < -kNoLength || u > kNoLength || v > kNoLength) return std::nullopt;
  return Lengths{t, u, v};
}
Solution quarter_straight_quarter(const View& g) {  // 8.11: L+ R-(pi/2) S- L-(pi/2) R+
  const double far = g.right.radius;
  if (far < 2) return std::nullopt;
  const double u = 4 - std::sqrt(far * far - 4);
  if (u > kNoLength) return std::nullopt;
  const double t = wrapped(std::atan2((4 - u) * g.xi - 2 * g.eta, -2 * g.xi + (u - 4) * g.eta));
  const double v = wrapped(t - g.yaw);
  if (t < -kNoLength || v < -kNoLength) return std::nullopt;
  return Lengths{t, u, v};
}

/// A formula and the word its lengths make.
struct Formula {
  Solution (*solve)(const View&);
  const char* steer;
  std::array<double, 5> (*spell)(const Lengths&);
};

constexpr auto kThree = [](const Lengths& l) -> std::array<double, 5> { return {l.t, l.u, l.v}; };
const std::array<Formula, 8> kFormulas{{
    {left_straight_left, "LSL", kThree},
    {left_straight_right, "LSR", kThree},
    {left_right_left, "LRL", kThree},
    {four_arcs_inner_opposed, "LRLR",
     [](const Lengths& l) -> std::array<double, 5> {
       return {l.t, l.u, -l.u, l.v};
     }},
    {four_arcs_inner_alike, "LRLR",
     [](const Lengths& l) -> std::array<double, 5> {
       return {l.t, l.u, l.u, l.v};
     }},
    {quarter_straight_left, "LRSL",
     [](const Lengths& l) -> std::array<double, 5> {
       return {l.t, -kPi / 2, l.u, l.v};
     }},
    {quarter_straight_right, "LRSR",
     [](const Lengths& l) -> std::array<double, 5> {
       return {l.t, -kPi / 2, l.u, l.v};
     }},
    {quarter_straight_quarter, "LRSLR",
     [](const Lengths& l) -> std::array<double, 5> {
       return {l.t, -kPi / 2, l.u, -kPi / 2, l.v};
     }},
}};

}  // namespace

std::vector<SteeringWord> reeds_shepp_words(const Pose2& from, const Pose2& to, double radius) {
  const WordGoal goal = goal_seen_from(from, to, radius);
  const double c = std::cos(goal.yaw), s = std::sin(goal.yaw);
  const WordGoal reversed{goal.x * c + goal.y * s, goal.x * s - goal.y * c, goal.yaw};
  std::vector<SteeringWord> words;
  for (const bool backwards : {false, true}) {
    for (const bool time : {false, true}) {
      for (const bool mirror : {false, true}) {
        WordGoal seen = backwards ? reversed : goal;
        if (time) seen.x = -seen.x, seen.yaw = -seen.yaw;
        if (mirror) seen.y = -seen.y, seen.yaw = -seen.yaw;
        const View view(seen);
        for (const Formula& formula : kFormulas) {
          const Solution solution = formula.solve(view);
          if (!solution) continue;
          const std::string_view steer = formula.steer;
          const auto lengths = formula.spell(*solution);
          SteeringWord word;
          for (std::size_t i = 0; i < steer.size(); ++i) {
            const std::size_t at = backwards ? steer.size() - 1 - i : i;
            const char turn = steer[i];
            word.steer[at] = mirror && turn != 'S' ? (turn == 'L' ? 'R' : 'L') : turn;
            word.length[at] = time ? -lengths[i] : lengths[i];
          }
          keep_if_it_arrives(words, word, goal);
        }
      }
    }
  }
  sort_words(words);
  return words;
}

}  // namespace stope::planner
