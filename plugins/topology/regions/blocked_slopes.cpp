// Problem: whether the Bresenham ray to a cell is open, without walking it.
// Idea: the cell of the ray of slope s at step k is k s, halves rounded up. So a cell (k, o) is on
// just the rays of slopes from (2 o - 1) / 2 k to before (2 o + 1) / 2 k that go on beyond it. The
// slopes are kept in bins, and of each bin the part that is not blocked. That it is one part at
// most is due to the bins being no wider than 1 / k: what a cell blocks reaches at least one end of
// a bin, or all of it.
// Cost: one look for each ray; for a cell that blocks, two divisions and the bins that it covers.
#include "plugins/topology/regions/blocked_slopes.hpp"

#include <algorithm>

namespace stope::topology {

void BlockedSlopes::clear(std::int32_t radius) {
  per_octant_ = kFewestBins;
  while (per_octant_ < static_cast<std::uint32_t>(radius)) per_octant_ *= 2;
  shift_ = kSlopeBits;
  for (std::uint32_t bins = per_octant_; bins > 1; bins /= 2) --shift_;
  bins_.assign(kOctants * per_octant_, Bin());
}

void BlockedSlopes::reach(std::int32_t radius) {
  while (per_octant_ < static_cast<std::uint32_t>(radius)) {
    bins_.resize(2 * bins_.size());
    // Each half of a bin has the same part of its slopes, as far as it goes.
    for (std::size_t i = bins_.size(); i-- > 0;) bins_[i] = bins_[i / 2];
    per_octant_ *= 2;
    --shift_;
  }
}

void BlockedSlopes::block(std::size_t octant, std::uint32_t along, std::uint32_t aside) {
  const RaySlope from = aside == 0 ? 0 : ray_slope(2 * aside - 1, 2 * along);
  const RaySlope last = aside == along ? kSteepest : ray_slope(2 * aside + 1, 2 * along) - 1;
  Bin* const bins = bins_.data() + octant * per_octant_;
  const std::uint32_t first_bin = from >> shift_, last_bin = last >> shift_;
  for (std::uint32_t i = first_bin; i <= last_bin; ++i) {
    Bin& bin = bins[i];
    const RaySlope low = i << shift_, high = low + ((RaySlope{1} << shift_) - 1);
    if (from <= low && last >= high) {
      bin.length = 0;
    } else if (from <= low) {
      // What is left begins after `last`.
      if (last < bin.begin) continue;
      const std::uint32_t less = last + 1 - bin.begin;
      bin.length = bin.length > less ? bin.length - less : 0;
      bin.begin = last + 1;
    } else {
      bin.length = from > bin.begin ? std::min(bin.length, from - bin.begin) : 0;
    }
  }
}

}  // namespace stope::topology
