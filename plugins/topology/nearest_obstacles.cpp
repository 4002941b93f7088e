#include "plugins/topology/nearest_obstacles.hpp"

namespace stope::topology {
namespace {

/// Rows of a band from its lowest one to the highest and lowest obstacle of each column, or kNone.
struct Extremes {
  static constexpr std::uint8_t kNone = 128;
  std::vector<std::uint8_t> highest, lowest;
};

/// One row more. Bytes, so that sixteen columns go at once: this looks at every cell of the map.
void look_at(const std::uint8_t* bits, std::uint8_t row, std::uint8_t* highest,
             std::uint8_t* lowest, std::size_t columns) {
  for (std::size_t i = 0; i < columns; ++i) {
    const auto free = static_cast<std::uint8_t>((bits[i] & kObstacle) - 1);  // all ones, or 0
    highest[i] = static_cast<std::uint8_t>((highest[i] & free) | (row & ~free));
    lowest[i] = std::min(lowest[i], static_cast<std::uint8_t>(free | row));
  }
}

}  // namespace

BandBorders::BandBorders(const FreeSpace& space)
    : stride_(static_cast<std::size_t>(space.stride())),
      bands_((space.height() + kRows - 1) / kRows),
      below_(static_cast<std::size_t>(bands_) * stride_),
      above_(static_cast<std::size_t>(bands_) * stride_) {
  static_assert(kRows < Extremes::kNone);
  std::vector<std::uint8_t> highest(stride_), lowest(below_.size());
  std::int32_t* below = below_.data();
  std::fill_n(below, stride_, -1);
  for (std::int32_t band = 0; band < bands_; ++band) {
    std::fill(highest.begin(), highest.end(), Extremes::kNone);
    std::uint8_t* low = lowest.data() + static_cast<std::size_t>(band) * stride_;
    std::fill_n(low, stride_, Extremes::kNone);
    const std::int32_t bottom = band * kRows, top = std::min(bottom + kRows, space.height());
    for (std::int32_t row = bottom; row < top; ++row)
      look_at(space.padded_row(row), static_cast<std::uint8_t>(row - bottom), highest.data(), low,
              stride_);
    if (band + 1 == bands_) break;
    for (std::size_t i = 0; i < stride_; ++i)
      below[i + stride_] = highest[i] == Extremes::kNone ? below[i] : bottom + highest[i];
    below += stride_;
  }
  std::int32_t* above = above_.data() + static_cast<std::size_t>(bands_ - 1) * stride_;
  std::fill_n(above, stride_, space.height());
  for (std::int32_t band = bands_; --band > 0; above -= stride_) {
    const std::uint8_t* low = lowest.data() + static_cast<std::size_t>(band) * stride_;
    for (std::size_t i = 0; i < stride_; ++i)
      *(above - stride_ + i) = low[i] == Extremes::kNone ? above[i] : band * kRows + low[i];
  }
}

}  // namespace stope::topology
