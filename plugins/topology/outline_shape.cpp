// Problem: an outline is a staircase of cell sides; say how long it is and where it really turns.
// Idea: a side's heading is a right angle, so positions and headings along an outline are sums of
// whole numbers. Differences of their prefix sums give chords and mean headings of any window, the
// same ones wherever the outline starts. Cost: linear in the outlines' length.
#include "plugins/topology/outline_shape.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace stope::topology {
namespace {

std::size_t at(std::int64_t place) { return static_cast<std::size_t>(place); }

/// Sums over a closed outline's edges, for windows that may pass its first edge.
class RoundSums {
 public:
  explicit RoundSums(std::size_t count) { sums_.reserve(count + 1), sums_.push_back(0); }
  void add(std::int64_t value) { sums_.push_back(sums_.back() + value); }
  /// Of the edges before `edge`, which may lie up to one round outside of the outline.
  std::int64_t before(std::int64_t edge) const {
    const auto count = static_cast<std::int64_t>(sums_.size()) - 1;
    if (edge < 0) return sums_[at(edge + count)] - sums_.back();
    if (edge > count) return sums_[at(edge - count)] + sums_.back();
    return sums_[at(edge)];
  }

 private:
  std::vector<std::int64_t> sums_;
};

/// The outline's heading at each edge, in right turns since its first edge.
std::vector<std::int64_t> headings(const Outline& outline, const std::vector<std::uint8_t>& sides) {
  std::vector<std::int64_t> result(at(outline.count), 0);
  for (std::int32_t i = 1; i < outline.count; ++i) {
    const int turn = (sides[at(outline.first + i - 1)] - sides[at(outline.first + i)] + 4) % 4;
    result[at(i)] = result[at(i) - 1] + (turn == 3 ? -1 : turn);
  }
  return result;
}

/// By the chord's extent across and along: what an edge counts.
constexpr std::int32_t kChordSides = 2 * kWayReach + 2;
std::vector<std::int64_t> shares_of_chords(std::int32_t reach) {
  std::vector<std::int64_t> shares;
  for (int dx = 0; dx < kChordSides; ++dx)
    for (int dy = 0; dy < kChordSides; ++dy)
      shares.push_back(
          std::llround(OutlineWays::kUnit * std::sqrt(static_cast<double>(dx * dx + dy * dy)) /
                       static_cast<double>(2 * reach + 1)));
  return shares;
}

/// A part of the length, in edges.
std::int64_t half_of(const TurnRule& rule, double part) {
  return std::llround(part * std::min(rule.length, 1e9));
}

/// Marks the edges where the heading turns right by `least` right angles within 2 * half edges.
void mark_turns(const std::vector<std::int64_t>& heading, std::int64_t all_round, std::int64_t half,
                double least, std::vector<bool>& turning) {
  const auto count = static_cast<std::int64_t>(heading.size());
  half = std::min(half, count / 4);
  const std::int64_t reach = half / 4;
  if (half < 2) return;
  RoundSums sums(heading.size());
  for (const std::int64_t right_turns : heading) sums.add(right_turns);
  // Beyond the first edge the heading goes on by a whole round.
  const auto before = [&](std::int64_t edge) {
    std::int64_t rounds = 0;
    if (edge < 0) rounds = -edge;
    if (edge > count) rounds = edge - count;
    return sums.before(edge) + rounds * all_round;
  };
  const auto mean = [&](std::int64_t edge) {
    return static_cast<double>(before(edge + reach + 1) - before(edge - reach)) /
           static_cast<double>(2 * reach + 1);
  };
  for (std::int64_t i = 0; i < count; ++i)
    if (mean(i + half) - mean(i - half) >= least) turning[at(i)] = true;
}

}  // namespace

std::vector<std::uint8_t> sides_of_edges(const Outlines& outlines) {
  std::vector<std::uint8_t> result(outlines.place.size(), 0);
  for (const auto& sides : outlines.sides)
    for (int side = 0; side < 4; ++side)
      if (const OutlineEdge edge = sides[at(side)];
          edge >= 0 && at(edge) < result.size() && outlines.of_edge[at(edge)] >= 0)
        result[at(edge)] = static_cast<std::uint8_t>(side);
  return result;
}

OutlineWays measure_ways(const Outlines& outlines) {
  const std::vector<std::uint8_t> sides = sides_of_edges(outlines);
  OutlineWays ways;
  for (std::size_t i = 0; i < outlines.list.size(); ++i)
    measure_way(outlines, sides, static_cast<std::int32_t>(i), ways);
  return ways;
}

void measure_way(const Outlines& outlines, const std::vector<std::uint8_t>& sides,
                 std::int32_t place, OutlineWays& ways) {
  constexpr std::array<int, 4> kEastward{0, -1, 0, 1}, kNorthward{1, 0, -1, 0};  // by Side
  const Outline& outline = outlines.list[at(place)];
  ways.way.resize(outlines.place.size(), 0);
  ways.whole.resize(outlines.list.size(), 0);
  const std::int32_t count = outline.count;
  const std::int32_t reach =
      count < kSmallOutline ? count / (kSmallOutline / kWayReach) : kWayReach;
  const std::vector<std::int64_t> shares = shares_of_chords(reach);
  const std::uint8_t* side = sides.data() + outline.first;
  const auto round = [&](std::int32_t edge) {
    return edge < 0 ? edge + count : edge < count ? edge : edge - count;
  };
  int dx = 0, dy = 0;  // of the chord around an edge
  for (std::int32_t edge = -reach; edge <= reach; ++edge) {
    dx += kEastward[side[round(edge)]];
    dy += kNorthward[side[round(edge)]];
  }
  std::int64_t way = 0;
  for (std::int32_t edge = 0; edge < count; ++edge) {
    ways.way[at(outline.first + edge)] = way;
    way += shares[at(std::abs(dx) * kChordSides + std::abs(dy))];
    const std::uint8_t gone = side[round(edge - reach)], next = side[round(edge + reach + 1)];
    dx += kEastward[next] - kEastward[gone];
    dy += kNorthward[next] - kNorthward[gone];
  }
  ways.whole[at(place)] = way;
}

OutlineTurns find_turns(const Outlines& outlines, const TurnRule& rule) {
  const std::vector<std::uint8_t> sides = sides_of_edges(outlines);
  OutlineTurns turns;
  for (std::size_t i = 0; i < outlines.list.size(); ++i)
    find_turns(outlines, sides, static_cast<std::int32_t>(i), rule, turns);
  return turns;
}

void find_turns(const Outlines& outlines, const std::vector<std::uint8_t>& sides,
                std::int32_t place, const TurnRule& rule, OutlineTurns& turns) {
  const double least = rule.angle / (std::numbers::pi / 2) - 1e-9;
  const Outline& outline = outlines.list[at(place)];
  turns.before.resize(outlines.place.size(), 0);
  turns.whole.resize(outlines.list.size(), 0);
  const auto heading = headings(outline, sides);
  const int last_turn =
      (sides[at(outline.first + outline.count - 1)] - sides[at(outline.first)] + 4) % 4;
  const std::int64_t all_round = heading.back() + (last_turn == 3 ? -1 : last_turn);
  std::vector<bool> turning(heading.size(), false);
  for (const double part : {0.5, 0.25, 0.125})
    mark_turns(heading, all_round, half_of(rule, part), least, turning);
  std::int32_t count = 0;
  for (std::int32_t i = 0; i < outline.count; ++i) {
    turns.before[at(outline.first + i)] = count;
    count += turning[at(i)] ? 1 : 0;
  }
  turns.whole[at(place)] = count;
}

std::int32_t reach_of_turns(const TurnRule& rule) {
  const std::int64_t half = half_of(rule, 0.5);
  return static_cast<std::int32_t>(half + half / 4 + 2);
}

}  // namespace stope::topology
