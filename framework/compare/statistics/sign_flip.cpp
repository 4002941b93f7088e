#include "framework/compare/statistics/sign_flip.hpp"

#include <cmath>
#include <vector>

#include "stope/random.hpp"

namespace stope {
namespace {

constexpr std::size_t kMostExact = 15;
constexpr int kRandomFlips = 10'000;

double sum_with_signs(std::span<const double> differences, std::uint64_t signs) {
  double sum = 0;
  for (std::size_t i = 0; i < differences.size(); ++i)
    sum += (signs >> i & 1) ? -differences[i] : differences[i];
  return sum;
}

}  // namespace

double sign_flip_probability(std::span<const double> differences, std::uint64_t seed) {
  double observed = 0, size = 0;
  for (const double difference : differences) {
    observed += difference;
    size += std::fabs(difference);
  }
  // Sums that differ by rounding alone are equal.
  const double least = std::fabs(observed) - 1e-12 * size;
  if (differences.size() <= kMostExact) {
    const std::uint64_t ways = std::uint64_t{1} << differences.size();
    std::uint64_t as_far = 0;
    for (std::uint64_t signs = 0; signs < ways; ++signs)
      as_far += std::fabs(sum_with_signs(differences, signs)) >= least ? 1 : 0;
    return static_cast<double>(as_far) / static_cast<double>(ways);
  }
  Random random(seed);
  int as_far = 1;
  for (int flip = 0; flip < kRandomFlips; ++flip) {
    double sum = 0;
    for (std::size_t i = 0; i < differences.size(); i += 64)
      sum += sum_with_signs(
          differences.subspan(i, std::min<std::size_t>(64, differences.size() - i)), random.bits());
    as_far += std::fabs(sum) >= least ? 1 : 0;
  }
  return static_cast<double>(as_far) / (kRandomFlips + 1);
}

double least_probability(std::size_t differences) {
  if (differences == 0) return 1;
  return differences <= kMostExact ? std::ldexp(1.0, 1 - static_cast<int>(differences))
                                   : 1.0 / (kRandomFlips + 1);
}

}  // namespace stope
