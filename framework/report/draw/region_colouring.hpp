#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace stope::report {

/// A number for each of `count` regions such that neighbours differ, from 0 and as few as a greedy
/// colouring by falling degree (Welsh and Powell, 1967) finds. Pairs that name no region are passed
/// over. Cost: linear but for sorting.
std::vector<std::uint32_t> region_colouring(
    std::size_t count, std::vector<std::pair<std::uint32_t, std::uint32_t>> neighbours);

}  // namespace stope::report
