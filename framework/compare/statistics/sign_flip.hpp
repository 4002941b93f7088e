#pragma once

#include <cstdint>
#include <span>

namespace stope {

/// The chance that paired differences at least as far from 0 in their mean come about if it is a
/// toss-up which of a pair is which (Fisher 1935; two-sided). Exact for up to 15 differences: all
/// 2^n ways are looked at; above, 10 000 random ones and the real one (Phipson and Smyth 2010).
/// Differences that are 0 tell nothing and change nothing. The sample must be finite; of an empty
/// one, or one of zeros, the chance is 1.
double sign_flip_probability(std::span<const double> differences, std::uint64_t seed);

/// The least chance that so many differences can have, all of them pointing one way.
double least_probability(std::size_t differences);

}  // namespace stope
