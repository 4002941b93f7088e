#pragma once

#include <cstdint>

namespace stope::source {

/// Smooth noise in [-1, 1] over the plane: bicubic-eased interpolation of random values at the
/// integer points (Perlin 1985, value variant). The same for the same seed and place.
double value_noise(std::uint64_t seed, double x, double y);

/// Three octaves of value noise with halving amplitudes, about [-1, 1].
double fractal_noise(std::uint64_t seed, double x, double y);

}  // namespace stope::source
