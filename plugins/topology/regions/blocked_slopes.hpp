#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "plugins/topology/regions/ring_table.hpp"

namespace stope::topology {

/// Which slopes of rays are blocked, by octant.
class BlockedSlopes {
 public:
  static constexpr std::size_t kOctants = 8;
  static constexpr std::uint32_t kFewestBins = 64;

  /// Nothing is blocked, by no cell further away than this.
  void clear(std::int32_t radius);
  /// Cells that block are up to so far away; not nearer than before.
  void reach(std::int32_t radius);
  /// A cell on the rays to cells beyond it, so many steps along and aside.
  void block(std::size_t octant, std::uint32_t along, std::uint32_t aside);
  /// The bins of an octant: a ray is blocked if the bin of its slope says so.
  struct Bin {
    RaySlope begin = 0;
    std::uint32_t length = ~std::uint32_t{0};  ///< of the slopes that are not blocked, or longer
    bool blocks(RaySlope slope) const { return slope - begin >= length; }
  };
  struct Bins {
    const Bin* bins;
    std::uint32_t shift;
    bool block(RaySlope slope) const { return bins[slope >> shift].blocks(slope); }
  };
  Bins bins(std::size_t octant) const { return {bins_.data() + octant * per_octant_, shift_}; }

 private:
  std::vector<Bin> bins_;
  std::uint32_t per_octant_ = kFewestBins, shift_ = 0;
};

}  // namespace stope::topology
