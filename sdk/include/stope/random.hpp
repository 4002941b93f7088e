#pragma once

#include <array>
#include <cstdint>

#include "stope/visibility.hpp"

namespace stope {

/// A pseudo-random generator that gives the same numbers on every platform (xoshiro256**, Blackman
/// and Vigna 2018), with distributions of its own, because those of the standard library may differ
/// between versions.
class STOPE_API Random {
 public:
  explicit Random(std::uint64_t seed);
  /// 64 random bits.
  std::uint64_t bits();
  /// Uniform in [0, 1).
  double uniform();
  /// Uniform in [low, high).
  double uniform(double low, double high);
  /// Uniform in {0, …, count - 1}; `count` > 0.
  std::uint64_t below(std::uint64_t count);
  /// Normal with mean 0 and deviation 1.
  double normal();

 private:
  std::array<std::uint64_t, 4> state_;
};

/// Mixes a seed with a number into a new seed, for generators of parts that must not depend on each
/// other's order.
STOPE_API std::uint64_t mix_seed(std::uint64_t seed, std::uint64_t number);

}  // namespace stope
