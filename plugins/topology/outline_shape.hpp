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

}  // namespace stope::topology
