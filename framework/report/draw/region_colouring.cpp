#include "framework/report/draw/region_colouring.hpp"

#include <algorithm>
#include <limits>
#include <numeric>

namespace stope::report {
namespace {

constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

}  // namespace

std::vector<std::uint32_t> region_colouring(
    std::size_t count, std::vector<std::pair<std::uint32_t, std::uint32_t>> neighbours) {
  std::erase_if(neighbours, [&](const auto& pair) {
    return pair.first == pair.second || pair.first >= count || pair.second >= count;
  });
  const std::size_t pairs = neighbours.size();
  for (std::size_t i = 0; i < pairs; ++i)
    neighbours.emplace_back(neighbours[i].second, neighbours[i].first);
  std::sort(neighbours.begin(), neighbours.end());
  neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
  std::vector<std::size_t> begin(count + 1);
  for (const auto& pair : neighbours) ++begin[pair.first + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<std::uint32_t> order(count);
  std::iota(order.begin(), order.end(), 0U);
  std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
    return begin[a + 1] - begin[a] > begin[b + 1] - begin[b];
  });
  std::vector<std::uint32_t> colour(count, kNone);
  std::vector<std::uint32_t> taken;
  for (const std::uint32_t region : order) {
    taken.clear();
    for (std::size_t k = begin[region]; k < begin[region + 1]; ++k)
      taken.push_back(colour[neighbours[k].second]);
    std::sort(taken.begin(), taken.end());
    std::uint32_t free = 0;
    for (const std::uint32_t other : taken) {
      if (other == free) ++free;
    }
    colour[region] = free;
  }
  return colour;
}

}  // namespace stope::report
