#include "plugins/topology/nearest_obstacles.hpp"

#include "plugins/topology/for_each_band.hpp"

namespace stope::topology {
namespace {

constexpr std::uint8_t kNone = 128;
static_assert(BandBorders::kRows < kNone);

/// By column the highest and the lowest row of a band with an obstacle, counted from its first one,
/// or kNone. In bytes, so that sixteen columns go at once: this looks at every cell of the map.
void find_extremes(const FreeSpace& space, std::int32_t bottom, std::int32_t top,
                   std::uint8_t* highest, std::uint8_t* lowest) {
  const std::int32_t columns = space.stride();
  std::fill_n(highest, columns, kNone);
  std::fill_n(lowest, columns, kNone);
  for (std::int32_t row = bottom; row < top; ++row) {
    const std::uint8_t* bits = space.padded_row(row);
    const auto count = static_cast<std::uint8_t>(row - bottom);
    for (std::int32_t i = 0; i < columns; ++i) {
      const auto free = static_cast<std::uint8_t>((bits[i] & kObstacle) - 1);  // all ones, or 0
      highest[i] = static_cast<std::uint8_t>((highest[i] & free) | (count & ~free));
      lowest[i] = std::min(lowest[i], static_cast<std::uint8_t>(free | count));
    }
  }
}

}  // namespace

BandBorders::BandBorders(const FreeSpace& space, const Checkpoint& checkpoint)
    : stride_(static_cast<std::size_t>(space.stride())),
      bands_((space.height() + kRows - 1) / kRows),
      below_(static_cast<std::size_t>(bands_) * stride_),
      above_(static_cast<std::size_t>(bands_) * stride_) {
  std::vector<std::uint8_t> highest(below_.size()), lowest(below_.size());
  const auto at = [&](std::int32_t band) { return static_cast<std::size_t>(band) * stride_; };
  for_each_band(bands_, checkpoint, [&] {
    return [&](std::int32_t band) {
      const std::int32_t bottom = band * kRows;
      find_extremes(space, bottom, std::min(bottom + kRows, space.height()),
                    highest.data() + at(band), lowest.data() + at(band));
    };
  });
  std::fill_n(below_.begin(), stride_, -1);
  for (std::int32_t band = 1; band < bands_; ++band)
    for (std::size_t i = at(band); i < at(band + 1); ++i)
      below_[i] = highest[i - stride_] == kNone ? below_[i - stride_]
                                                : (band - 1) * kRows + highest[i - stride_];
  std::fill_n(above_.end() - static_cast<std::ptrdiff_t>(stride_), stride_, space.height());
  for (std::int32_t band = bands_ - 1; band-- > 0;)
    for (std::size_t i = at(band); i < at(band + 1); ++i)
      above_[i] = lowest[i + stride_] == kNone ? above_[i + stride_]
                                               : (band + 1) * kRows + lowest[i + stride_];
}

}  // namespace stope::topology
