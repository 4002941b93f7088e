// Problem: preparing a grid for fast search is 10^10 times "is this way over here cheaper?".
// Idea: rows of costs stand side by side, so eight ways over eight nodes are compared for several
// ends at once, and each row is loaded and stored once for all eight. On processors with AVX2 the
// same code is compiled for it; whole numbers give the same bytes either way.
#include "plugins/planner/min_plus.hpp"

#include <algorithm>

namespace stope::planner {
namespace {

using Costs = std::array<std::uint32_t, kRowsAtOnce>;
using Rows = std::array<const std::uint32_t*, kRowsAtOnce>;

[[gnu::always_inline]] inline void take(std::uint32_t* __restrict to, const Costs& costs,
                                        const Rows& rows, std::uint32_t count) {
  const auto [c0, c1, c2, c3, c4, c5, c6, c7] = costs;
  const auto [r0, r1, r2, r3, r4, r5, r6, r7] = rows;
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t a = std::min(c0 + r0[i], c1 + r1[i]), b = std::min(c2 + r2[i], c3 + r3[i]);
    const std::uint32_t c = std::min(c4 + r4[i], c5 + r5[i]), d = std::min(c6 + r6[i], c7 + r7[i]);
    to[i] = std::min(to[i], std::min(std::min(a, b), std::min(c, d)));
  }
}

#if defined(__x86_64__)
[[gnu::target("avx2")]] void take_avx2(std::uint32_t* to, const Costs& costs, const Rows& rows,
                                       std::uint32_t count) {
  take(to, costs, rows, count);
}
#endif

}  // namespace

void take_least_sums(std::uint32_t* to, const Costs& costs, const Rows& rows, std::uint32_t count) {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx2")) return take_avx2(to, costs, rows, count);
#endif
  take(to, costs, rows, count);
}

}  // namespace stope::planner
