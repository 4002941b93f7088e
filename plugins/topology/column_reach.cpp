#include "plugins/topology/column_reach.hpp"

#include <algorithm>

namespace stope::topology {
namespace {

/// One step along the columns: rows to the nearest obstacle, 0 in obstacles.
void step_reach(const std::uint8_t* bits, const std::uint16_t* previous, std::uint16_t* next,
                std::int32_t count) {
  for (std::int32_t i = 0; i < count; ++i) {
    const auto free = static_cast<std::uint16_t>((bits[i] & kObstacle) - 1);  // all ones, or 0
    next[i] = static_cast<std::uint16_t>(static_cast<std::uint16_t>(previous[i] + 1) & free);
  }
}

/// The same for a part of a row that has values already; where they change.
RowSpan renew_reach(const std::uint8_t* bits, const std::uint16_t* previous, std::uint16_t* next,
                    const RowSpan& part) {
  RowSpan changed{part.row, part.end, part.begin};
  for (std::int32_t i = part.begin; i < part.end; ++i) {
    const auto reach =
        static_cast<std::uint16_t>(bits[i] & kObstacle ? 0 : previous[i] + std::uint16_t{1});
    if (reach == next[i]) continue;
    next[i] = reach;
    changed.begin = std::min(changed.begin, i);
    changed.end = i + 1;
  }
  return changed;
}

}  // namespace

ColumnReach::ColumnReach(const FreeSpace& space, const Checkpoint& checkpoint)
    : down_(space.width(), space.height()), up_(space.width(), space.height()) {
  const std::int32_t height = space.height(), stride = space.stride();
  for (PaddedGrid<std::uint16_t>* reach : {&down_, &up_}) {
    std::fill_n(reach->padded_row(-1), stride, std::uint16_t{0});
    std::fill_n(reach->padded_row(height), stride, std::uint16_t{0});
  }
  for (std::int32_t row = 0; row < height; ++row) {
    if (row % kRowsBetweenCheckpoints == 0) checkpoint();
    step_reach(space.padded_row(row), down_.padded_row(row - 1), down_.padded_row(row), stride);
  }
  for (std::int32_t row = height; row-- > 0;) {
    if (row % kRowsBetweenCheckpoints == 0) checkpoint();
    step_reach(space.padded_row(row), up_.padded_row(row + 1), up_.padded_row(row), stride);
  }
}

std::vector<RowSpan> ColumnReach::update(const FreeSpace& space, const CellWindow& changed) {
  const std::int32_t height = space.height(), begin = changed.column,
                     end = changed.column + changed.width;
  const std::int32_t bottom = changed.row, top = changed.row + changed.height;
  const auto renew = [&](PaddedGrid<std::uint16_t>& reach, std::int32_t row, std::int32_t from) {
    return renew_reach(space.padded_row(row) + 1, reach.padded_row(from) + 1,
                       reach.padded_row(row) + 1, {row, begin, end});
  };
  // Beyond the window a change goes on as far as it does not meet an obstacle.
  std::vector<RowSpan> spans, above;
  for (std::int32_t row = top; row-- > 0;) {
    const RowSpan span = renew(up_, row, row + 1);
    if (span.begin < span.end)
      spans.push_back(span);
    else if (row < bottom)
      break;
  }
  std::reverse(spans.begin(), spans.end());
  for (std::int32_t row = bottom; row < height; ++row) {
    const RowSpan span = renew(down_, row, row - 1);
    if (span.begin < span.end)
      above.push_back(span);
    else if (row >= top)
      break;
  }
  // Rows of the window may be in both.
  std::vector<RowSpan> all;
  auto a = spans.cbegin(), b = above.cbegin();
  while (a != spans.cend() || b != above.cend()) {
    if (b == above.cend() || (a != spans.cend() && a->row < b->row)) {
      all.push_back(*a++);
    } else if (a == spans.cend() || b->row < a->row) {
      all.push_back(*b++);
    } else {
      all.push_back({a->row, std::min(a->begin, b->begin), std::max(a->end, b->end)});
      ++a, ++b;
    }
  }
  return all;
}

}  // namespace stope::topology
