#pragma once

#include <cstdint>
#include <vector>

#include "plugins/topology/outlines.hpp"

namespace stope::topology {

/// How far it is along outlines, free of the raster's steps. In whole numbers, so that a difference
/// does not depend on where an outline starts.
struct OutlineWays {
  static constexpr double kUnit = 1024;  ///< of one cell
  std::vector<std::int64_t> way;         ///< by edge: from its outline's first edge
  std::vector<std::int64_t> whole;       ///< by outline: all the way round

  /// The shorter way between two edges of one outline, in cells.
  double between(OutlineEdge a, OutlineEdge b, std::int32_t outline) const {
    const std::int64_t apart =
        way[static_cast<std::size_t>(a < b ? b : a)] - way[static_cast<std::size_t>(a < b ? a : b)];
    const std::int64_t round = whole[static_cast<std::size_t>(outline)] - apart;
    return static_cast<double>(apart < round ? apart : round) / kUnit;
  }
};

/// The sides of edges, by edge.
std::vector<std::uint8_t> sides_of_edges(const Outlines& outlines);

/// Measures outlines: the way past an edge is the length of the chord of five edges around it,
/// divided by five. Straight walls of any direction come out within 2 %; each edge's share depends
/// on its neighbourhood alone (of an outline of less than kSmallOutline edges also on how many
/// these are). Cost: linear in the outlines' length.
OutlineWays measure_ways(const Outlines& outlines);
/// Measures one, by its place in the list, anew.
void measure_way(const Outlines& outlines, const std::vector<std::uint8_t>& sides,
                 std::int32_t outline, OutlineWays& ways);
constexpr std::int32_t kWayReach = 2, kSmallOutline = 8 * kWayReach;

/// Where outlines turn towards their free side, as at the corners of a face.
struct OutlineTurns {
  std::vector<std::int32_t> before;  ///< by edge: turning edges of its outline before it
  std::vector<std::int32_t> whole;   ///< by outline: turning edges on all of it

  /// Whether the outline turns on the shorter way (in edges) between two of its edges.
  bool between(OutlineEdge a, OutlineEdge b, const Outline& outline, std::int32_t number) const {
    const OutlineEdge low = a < b ? a : b, high = a < b ? b : a;
    const std::int32_t inside =
        before[static_cast<std::size_t>(high)] - before[static_cast<std::size_t>(low)];
    const bool inside_is_shorter = 2 * (high - low) <= outline.count;
    return inside_is_shorter ? inside > 0 : whole[static_cast<std::size_t>(number)] > inside;
  }
};

/// What counts as a turn.
struct TurnRule {
  double angle = 1.0;    ///< radians, the least
  double length = 80.0;  ///< edges within which the outline turns so far; also half and a quarter
};

/// An edge turns if the outline's heading, averaged over a quarter of the length, turns by the
/// angle from half the length before it to half the length behind it. Headings of a raster's
/// outline are right angles, whose sum is exact. Cost: linear in the outlines' length.
OutlineTurns find_turns(const Outlines& outlines, const TurnRule& rule);
/// Finds those of one, by its place in the list, anew.
void find_turns(const Outlines& outlines, const std::vector<std::uint8_t>& sides,
                std::int32_t outline, const TurnRule& rule, OutlineTurns& turns);
/// Within how many edges of a change of its outline an edge can come to turn, or no longer; in an
/// outline of less than four times as many edges anywhere.
std::int32_t reach_of_turns(const TurnRule& rule);

}  // namespace stope::topology
