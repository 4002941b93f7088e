#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "plugins/topology/named_outlines.hpp"

namespace stope::topology {

/// Where outlines turn towards their free side, as at the corners of a face.
struct OutlineTurns {
  std::vector<std::uint8_t> turning;  ///< by edge: 1 where its outline turns
  std::vector<std::int32_t> before;   ///< by edge: turning edges of its outline before it
  std::vector<std::int32_t> whole;    ///< by outline: turning edges on all of it

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

/// Finds those of one outline anew, by its place in the list. Of runs of its edges that stayed and
/// whose numbers before are known, turns are only looked for beside the ends. Cost: linear in what
/// is looked at and, with a very small constant, in the outline's length.
void find_turns(const Outlines& outlines, const std::vector<std::uint8_t>& sides,
                std::int32_t outline, std::span<const StayedRun> stayed, const TurnRule& rule,
                OutlineTurns& turns);

/// Within how many edges of a change of its outline an edge can come to turn, or no longer; in an
/// outline of less than four times as many edges anywhere.
std::int32_t reach_of_turns(const TurnRule& rule);

}  // namespace stope::topology
