#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <cstring>

#include "plugins/topology/free_space.hpp"

namespace stope::topology {

/// The first column from `column` on that is (kObstacle) or is not (0) an obstacle, or `end`.
/// `bits` is the row from column 0 on. Looks at eight cells at a time.
inline std::int32_t find_column(const std::uint8_t* bits, std::int32_t column, std::int32_t end,
                                std::uint8_t wanted) {
  constexpr std::uint64_t kEight = 0x0101010101010101ULL * kObstacle;
  for (; column + 8 <= end; column += 8) {
    std::uint64_t cells = 0;
    std::memcpy(&cells, bits + column, 8);
    const std::uint64_t hits = (wanted ? cells : ~cells) & kEight;
    if (hits) return column + std::countr_zero(hits) / 8;
  }
  while (column < end && (bits[column] & kObstacle) != wanted) ++column;
  return std::min(column, end);
}

/// Calls visit(begin, end) for each run of free cells of a row, from west to east: `begin` is its
/// first column, `end` that of the obstacle after it.
template <class Visit>
void for_each_free_run(const FreeSpace& space, std::int32_t row, Visit visit) {
  const std::uint8_t* bits = space.padded_row(row) + 1;
  const std::int32_t width = space.width();
  for (std::int32_t begin = find_column(bits, 0, width, 0); begin < width;) {
    const std::int32_t end = find_column(bits, begin + 1, width, kObstacle);
    visit(begin, end);
    begin = find_column(bits, end + 1, width, 0);
  }
}

}  // namespace stope::topology
