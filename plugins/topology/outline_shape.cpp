// Problem: an outline is a staircase of cell sides; say how long it is.
// Idea: an edge counts what the chord of the edges around it is long, in whole numbers, so ways are
// differences of sums, the same ones wherever the outline starts.
// Cost: linear in the outlines' length.
#include "plugins/topology/outline_shape.hpp"

#include <array>
#include <cmath>

namespace stope::topology {
namespace {

std::size_t at(std::int64_t place) { return static_cast<std::size_t>(place); }

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

}  // namespace stope::topology
