#pragma once

#include <array>
#include <cstdint>

namespace stope::planner {

/// Rows that are taken at once.
inline constexpr std::uint32_t kRowsAtOnce = 8;

/// to[i] = min(to[i], costs[0] + rows[0][i], …, costs[7] + rows[7][i]) for all i < count; sums wrap
/// at 2^32. `to` may be none of the rows.
void take_least_sums(std::uint32_t* to, const std::array<std::uint32_t, kRowsAtOnce>& costs,
                     const std::array<const std::uint32_t*, kRowsAtOnce>& rows,
                     std::uint32_t count);

}  // namespace stope::planner
