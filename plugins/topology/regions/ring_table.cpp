#include "plugins/topology/regions/ring_table.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace stope::topology {
namespace {

/// 0 for angles in [0, pi), 1 for [pi, 2 pi).
int half(const CellOffset& cell) { return cell.dy < 0 || (cell.dy == 0 && cell.dx < 0) ? 1 : 0; }

bool by_angle(const CellOffset& a, const CellOffset& b) {
  if (half(a) != half(b)) return half(a) < half(b);
  const std::int64_t cross = std::int64_t{a.dx} * b.dy - std::int64_t{a.dy} * b.dx;
  if (cross != 0) return cross > 0;
  return std::tie(a.dx, a.dy) < std::tie(b.dx, b.dy);
}

}  // namespace

std::span<const CellOffset> RingTable::ring(std::int32_t radius) {
  reach(radius);
  const auto r = static_cast<std::size_t>(radius);
  return std::span(cells_).subspan(begin_[r], begin_[r + 1] - begin_[r]);
}

std::size_t RingTable::cells_within(std::int32_t radius) {
  reach(radius);
  return begin_[static_cast<std::size_t>(radius) + 1];
}

void RingTable::reach(std::int32_t radius) {
  while (begin_.size() < static_cast<std::size_t>(radius) + 2) {
    const auto r = static_cast<std::int64_t>(begin_.size()) - 1;
    // The distance rounds to r if r - 1/2 <= distance < r + 1/2; four times its square is whole.
    const std::int64_t least = r == 0 ? 0 : (2 * r - 1) * (2 * r - 1);
    const std::int64_t past = (2 * r + 1) * (2 * r + 1);
    for (std::int64_t dy = -r; dy <= r; ++dy) {
      const auto add = [&](std::int64_t dx) {
        const std::int64_t fourfold = 4 * (dx * dx + dy * dy);
        if (fourfold < least || fourfold >= past) return false;
        cells_.push_back({static_cast<std::int16_t>(dx), static_cast<std::int16_t>(dy)});
        if (dx != 0)
          cells_.push_back({static_cast<std::int16_t>(-dx), static_cast<std::int16_t>(dy)});
        return true;
      };
      auto dx = static_cast<std::int64_t>(
          std::sqrt(std::max(0.0, static_cast<double>(past) / 4 - static_cast<double>(dy * dy))));
      ++dx;
      while (dx >= 0 && !add(dx)) --dx;
      while (--dx >= 0 && add(dx)) {
      }
    }
    std::sort(cells_.begin() + static_cast<std::ptrdiff_t>(begin_.back()), cells_.end(), by_angle);
    begin_.push_back(cells_.size());
  }
}

}  // namespace stope::topology
