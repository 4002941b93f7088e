#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace stope::topology {

/// Slope of a ray within an octant, 0 to 1, in units that tell apart any two slopes of rays and of
/// edges of cells in reach of the ring table.
using RaySlope = std::uint32_t;
constexpr std::uint32_t kSlopeBits = 30;
constexpr RaySlope kSteepest = (RaySlope{1} << kSlopeBits) - 1;

/// The slope over / under, which is not above 1: its place among all others, 1 just below 2^30.
/// Denominators are at most 32 000, so different slopes are further apart than a unit.
inline RaySlope ray_slope(std::uint64_t over, std::uint64_t under) {
  const std::uint64_t slope = (over << kSlopeBits) / under;
  return slope > kSteepest ? kSteepest : static_cast<RaySlope>(slope);
}

/// A cell seen from the cell a region grows from: steps along the main axis of its octant, and
/// aside, which are at most as many.
struct OctantCell {
  std::uint16_t along = 0, aside = 0;
  RaySlope slope = 0;
};

/// The rings of the circular scan: ring r holds the cells whose distance rounds to r. Together they
/// are every cell once.
class RingTable {
 public:
  static constexpr std::int32_t kMostRings = 16000;  ///< what the slopes can tell apart

  /// The cells of a ring in one octant, by slope; the first is on the axis, the last may be on the
  /// diagonal. The other octants mirror it.
  std::span<const OctantCell> octant(std::int32_t radius);
  /// How many cells a whole ring has, and the rings 0 … radius.
  std::size_t cells_in(std::int32_t radius) {
    return cells_within(radius) - (radius == 0 ? 0 : cells_within(radius - 1));
  }
  std::size_t cells_within(std::int32_t radius);

 private:
  void reach(std::int32_t radius);
  std::vector<OctantCell> cells_;
  std::vector<std::size_t> begin_{0};  ///< by ring; the last is the end
  std::vector<std::size_t> within_;    ///< by ring
};

/// Columns that the disc of rings 0 … radius reaches to either side, in a row so far from its
/// middle, which it has.
std::int32_t disc_reach(std::int32_t radius, std::int32_t row);

}  // namespace stope::topology
