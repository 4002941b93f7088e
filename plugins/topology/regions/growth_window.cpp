// Problem: growth looks at the cells around its point again and again, ring by ring, which in a
// large grid is far across memory, and asks first how far everything is open.
// Idea: copy what is near, row by row, as far as growth has come, and look for the nearest cell
// that is not open on the way: outwards in each row, eight cells at a time.
// Cost: a copy of the square around the rings.
#include "plugins/topology/regions/growth_window.hpp"

#include <algorithm>
#include <cstring>
#include <utility>

namespace stope::topology {
namespace {

constexpr std::uint64_t kAllOpen = 0x0101010101010101;

std::uint64_t eight_cells(const std::uint8_t* cells) {
  std::uint64_t word;
  std::memcpy(&word, cells, sizeof(word));
  return word;
}

}  // namespace

std::int32_t length_of_open(const std::uint8_t* cells, std::int32_t count) {
  std::int32_t length = 0;
  while (length + 8 <= count && eight_cells(cells + length) == kAllOpen) length += 8;
  while (length < count && cells[length] == GrowthWindow::kOpen) ++length;
  return length;
}

std::int32_t length_of_failed(const std::uint8_t* cells, std::int32_t count) {
  constexpr std::uint64_t kAllFailed = GrowthWindow::kFailed * kAllOpen;
  std::int32_t length = 0;
  while (length + 8 <= count && (eight_cells(cells + length) & kAllFailed) == kAllFailed)
    length += 8;
  while (length < count && (cells[length] & GrowthWindow::kFailed)) ++length;
  return length;
}

std::size_t count_failed(const std::uint8_t* cells, std::int32_t count) {
  constexpr std::uint64_t kAllFailed = GrowthWindow::kFailed * kAllOpen;
  std::size_t failed = 0;
  // The product's highest byte is the sum of the eight, which are 0 or 2.
  for (; count >= 8; cells += 8, count -= 8)
    failed += ((eight_cells(cells) & kAllFailed) * kAllOpen >> 57);
  for (; count > 0; ++cells, --count) failed += *cells & GrowthWindow::kFailed ? 1 : 0;
  return failed;
}

void GrowthWindow::start(const PaddedGrid<std::uint8_t>& open, CellIndex from,
                         BeforeReading before_reading) {
  open_ = &open;
  before_reading_ = std::move(before_reading);
  from_ = from;
  column_ = open.column(from), row_ = open.row(from);
  filled_ = -1;
  nearest_ = std::numeric_limits<std::int64_t>::max();
}

void GrowthWindow::fill(std::int32_t reach) {
  const std::int32_t before = filled_;
  if (reach > capacity_) {
    const std::int32_t old = capacity_;
    const std::vector<std::uint8_t> kept = std::move(cells_);
    capacity_ = std::max(reach, 2 * old);
    cells_.assign(static_cast<std::size_t>(stride() * stride()), 0);
    for (std::int32_t dy = -before; dy <= before; ++dy)
      std::copy_n(kept.data() + (std::ptrdiff_t{dy} + old) * (2 * old + 1) + old - before,
                  2 * before + 1, middle() + dy * stride() - before);
  }
  filled_ = reach;
  if (before_reading_) before_reading_(reach);
  // Further out than the nearest one there is no nearer one.
  const bool look = nearest_ > std::int64_t{before} * before;
  for (std::int32_t dy = -reach; dy <= reach; ++dy) {
    const bool whole = dy < -before || dy > before;
    if (whole) {
      copy(dy, -reach, reach);
    } else {
      copy(dy, -reach, -before - 1);
      copy(dy, before + 1, reach);
    }
    if (look) look_for_nearest(dy, whole ? 0 : before + 1, reach);
  }
}

void GrowthWindow::copy(std::int32_t dy, std::int32_t first, std::int32_t last) {
  std::uint8_t* to = middle() + dy * stride();
  const std::int32_t row = row_ + dy;
  if (row < 0 || row >= open_->height()) {
    std::memset(to + first, 0, static_cast<std::size_t>(last - first + 1));
    return;
  }
  const std::int32_t begin = std::clamp(-column_, first, last + 1);
  const std::int32_t end = std::clamp(open_->width() - column_, begin, last + 1);
  std::memset(to + first, 0, static_cast<std::size_t>(begin - first));
  std::memcpy(to + begin, open_->data() + from_ + std::ptrdiff_t{dy} * open_->stride() + begin,
              static_cast<std::size_t>(end - begin));
  std::memset(to + end, 0, static_cast<std::size_t>(last + 1 - end));
}

void GrowthWindow::look_for_nearest(std::int32_t dy, std::int32_t from, std::int32_t reach) {
  const std::uint8_t* cells = row(dy);
  const auto note = [&](std::int64_t dx) {
    nearest_ = std::min(nearest_, dx * dx + std::int64_t{dy} * dy);
  };
  const std::int32_t right = from + length_of_open(cells + from, reach - from + 1);
  if (right <= reach) note(right);
  std::int32_t left = from;
  while (left + 7 <= reach && eight_cells(cells - left - 7) == kAllOpen) left += 8;
  while (left <= reach && cells[-left] == kOpen) ++left;
  if (left <= reach) note(left);
}

}  // namespace stope::topology
