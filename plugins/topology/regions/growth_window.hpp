#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include "plugins/topology/padded_grid.hpp"

namespace stope::topology {

/// The open cells around a growth point, side by side in memory, and what becomes of them.
class GrowthWindow {
 public:
  enum State : std::uint8_t { kOpen = 1, kFailed = 2 };

  /// Called before cells up to so many columns and rows away are read for the first time.
  using BeforeReading = std::function<void(std::int32_t reach)>;
  void start(const PaddedGrid<std::uint8_t>& open, CellIndex from, BeforeReading before_reading);
  /// From now on cells up to so many columns and rows away are here; those that the grid does not
  /// have are not open.
  void reach(std::int32_t radius) {
    while (filled_ < radius) fill(filled_ + kStep);
  }
  /// Whether all cells of a ring are open, as all of those before it are, and none has failed.
  bool ring_is_open(std::int32_t radius) {
    const std::int64_t last = std::int64_t{radius} * radius + radius;
    while (filled_ < radius && nearest_ > last) fill(filled_ + kStep);
    return nearest_ > last;
  }

  std::ptrdiff_t stride() const { return 2 * std::ptrdiff_t{capacity_} + 1; }
  /// The state of the growth point; others are at dy * stride() + dx from it.
  std::uint8_t* middle() {
    return cells_.data() + static_cast<std::ptrdiff_t>(capacity_) * (stride() + 1);
  }
  const std::uint8_t* row(std::int32_t dy) const {
    return cells_.data() + (std::ptrdiff_t{dy} + capacity_) * stride() + capacity_;
  }

 private:
  static constexpr std::int32_t kStep = 32;

  void fill(std::int32_t reach);
  void copy(std::int32_t dy, std::int32_t first, std::int32_t last);
  void look_for_nearest(std::int32_t dy, std::int32_t from, std::int32_t reach);

  const PaddedGrid<std::uint8_t>* open_ = nullptr;
  BeforeReading before_reading_;
  CellIndex from_ = 0;
  std::int32_t column_ = 0, row_ = 0;
  std::vector<std::uint8_t> cells_;  ///< State, rows of 2 * capacity_ + 1
  std::int32_t capacity_ = -1, filled_ = -1;
  /// Squared distance of the nearest cell that is not open, of those that are here.
  std::int64_t nearest_ = std::numeric_limits<std::int64_t>::max();
};

/// How many of the cells from `cells` on are open and have not failed, or have failed; at most
/// `count`.
std::int32_t length_of_open(const std::uint8_t* cells, std::int32_t count);
std::int32_t length_of_failed(const std::uint8_t* cells, std::int32_t count);
std::size_t count_failed(const std::uint8_t* cells, std::int32_t count);

}  // namespace stope::topology
