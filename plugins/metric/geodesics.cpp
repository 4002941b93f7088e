// Problem: the exact length of the shortest way between two points among square obstacles.
// Idea: such a way is straight but for turns at corners of obstacles (Lozano-Perez and Wesley
// 1979), and turns there towards the obstacle. So A* over corners, whose lines of sight are found
// when a corner is first reached and kept, gives it exactly. Cost: in a pit of 1000 x 1000 cells
// some thousand corners a question, some milliseconds.
#include "plugins/metric/geodesics.hpp"

#include <cmath>
#include <functional>
#include <queue>
#include <utility>

#include "plugins/metric/lines_of_sight.hpp"

namespace stope::metric {
namespace {

constexpr std::int64_t kUnit = LatticePoint::kUnit;

LatticePoint point_of(const TurningCorner& corner) {
  return {corner.column * kUnit, corner.line * kUnit};
}

double distance(LatticePoint a, LatticePoint b) {
  const auto x = static_cast<double>(a.x - b.x), y = static_cast<double>(a.y - b.y);
  return std::sqrt(x * x + y * y);
}

}  // namespace

Geodesics::Geodesics(const FreeCells& cells)
    : frame_(cells.frame),
      space_(cells),
      seen_(space_.corners().size()),
      looked_(space_.corners().size()),
      states_(space_.corners().size()) {}

std::optional<LatticePoint> Geodesics::to_lattice(const Vector2& place) const {
  const Vector2 cells = frame_.to_grid(place.x(), place.y());
  if (!(cells.x() >= 0 && cells.y() >= 0 && cells.x() <= frame_.width &&
        cells.y() <= frame_.height))
    return std::nullopt;
  const LatticePoint point{std::llround(cells.x() * kUnit), std::llround(cells.y() * kUnit)};
  if (space_.run_at(point.y / kUnit, point.x) != nullptr) return point;
  // On a line of the lattice the row below may be the free one.
  const bool below = point.y % kUnit == 0 && space_.run_at(point.y / kUnit - 1, point.x) != nullptr;
  return below ? std::optional(point) : std::nullopt;
}

const std::vector<Geodesics::Seen>& Geodesics::seen_from(std::uint32_t corner) {
  if (looked_[corner]) return seen_[corner];
  looked_[corner] = 1;
  const TurningCorner& here = space_.corners()[corner];
  for (const std::uint32_t other : corners_seen(space_, point_of(here), &here))
    seen_[corner].push_back({other, distance(point_of(here), point_of(space_.corners()[other]))});
  return seen_[corner];
}

double Geodesics::search(LatticePoint from, LatticePoint to) {
  if (sees(space_, from, to)) return distance(from, to);
  ++question_;
  for (const std::uint32_t corner : corners_seen(space_, to)) {
    states_[corner].to_goal = distance(point_of(space_.corners()[corner]), to);
    states_[corner].goal_question = question_;
  }
  using Open = std::pair<double, std::uint32_t>;  // least length of a way through, corner
  std::priority_queue<Open, std::vector<Open>, std::greater<>> open;
  const auto reach = [&](std::uint32_t corner, double travelled) {
    State& state = states_[corner];
    if (state.question == question_ && state.travelled <= travelled) return;
    state.question = question_;
    state.travelled = travelled;
    open.emplace(travelled + distance(point_of(space_.corners()[corner]), to), corner);
  };
  for (const std::uint32_t corner : corners_seen(space_, from))
    reach(corner, distance(from, point_of(space_.corners()[corner])));
  double best = kUnreachable;
  while (!open.empty() && open.top().first < best) {
    const auto [through, corner] = open.top();
    open.pop();
    const State state = states_[corner];
    const double least = state.travelled + distance(point_of(space_.corners()[corner]), to);
    if (through > least) continue;  // reached by a shorter way since
    if (state.goal_question == question_) best = std::min(best, state.travelled + state.to_goal);
    for (const Seen& seen : seen_from(corner)) reach(seen.corner, state.travelled + seen.distance);
  }
  return best;
}

std::optional<double> Geodesics::between(const Vector2& from, const Vector2& to) {
  const auto a = to_lattice(from), b = to_lattice(to);
  if (!a || !b) return std::nullopt;
  const double parts = search(*a, *b);
  return parts == kUnreachable ? parts : parts * frame_.resolution / static_cast<double>(kUnit);
}

}  // namespace stope::metric
