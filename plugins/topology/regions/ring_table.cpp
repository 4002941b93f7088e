#include "plugins/topology/regions/ring_table.hpp"

#include <cmath>
#include <utility>

namespace stope::topology {
namespace {

/// The largest whole number whose square is at most this.
std::int64_t whole_root(std::int64_t square) {
  auto root = static_cast<std::int64_t>(std::sqrt(static_cast<double>(square)));
  while (root * root > square) --root;
  while ((root + 1) * (root + 1) <= square) ++root;
  return root;
}

}  // namespace

std::int32_t disc_reach(std::int32_t radius, std::int32_t row) {
  const std::int64_t r = radius, y = row;
  return static_cast<std::int32_t>(whole_root(r * r + r - y * y));
}

std::span<const OctantCell> RingTable::octant(std::int32_t radius) {
  reach(radius);
  const auto r = static_cast<std::size_t>(radius);
  return std::span(cells_).subspan(begin_[r], begin_[r + 1] - begin_[r]);
}

std::size_t RingTable::cells_within(std::int32_t radius) {
  reach(radius);
  return within_[static_cast<std::size_t>(radius)];
}

void RingTable::reach(std::int32_t radius) {
  while (within_.size() <= static_cast<std::size_t>(radius)) {
    const auto r = static_cast<std::int64_t>(within_.size());
    // The distance rounds to r if r - 1/2 <= distance < r + 1/2; its square is whole.
    const std::int64_t before = r * r - r, last = r * r + r;
    std::size_t on_diagonal = 0;
    for (std::int64_t aside = 0; 2 * aside * aside <= last; ++aside) {
      std::int64_t along = whole_root(last - aside * aside);
      for (; along >= aside && (r == 0 || along * along + aside * aside > before); --along) {
        on_diagonal += along == aside ? 1 : 0;
        const RaySlope slope = r == 0 ? 0
                                      : ray_slope(static_cast<std::uint64_t>(aside),
                                                  static_cast<std::uint64_t>(along));
        cells_.push_back(
            {static_cast<std::uint16_t>(along), static_cast<std::uint16_t>(aside), slope});
        // Nearly in order already.
        for (std::size_t i = cells_.size() - 1; i > begin_.back(); --i) {
          if (cells_[i - 1].slope <= slope) break;
          std::swap(cells_[i - 1], cells_[i]);
        }
      }
    }
    const std::size_t own = cells_.size() - begin_.back();
    // Those on an axis or a diagonal are in two octants.
    within_.push_back(r == 0 ? 1 : within_.back() + 8 * own - 4 - 4 * on_diagonal);
    begin_.push_back(cells_.size());
  }
}

}  // namespace stope::topology
