#include "plugins/source/synthetic_pit/noise.hpp"

#include <cmath>

namespace stope::source {
namespace {

// SplitMix64's finaliser over the two coordinates: cheap, and good enough to look like nothing.
double lattice(std::uint64_t seed, std::int64_t column, std::int64_t row) {
  std::uint64_t z = seed ^ (static_cast<std::uint64_t>(column) * 0x9e3779b97f4a7c15ULL) ^
                    (static_cast<std::uint64_t>(row) * 0xd1b54a32d192ed03ULL);
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ULL;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebULL;
  z ^= z >> 31;
  return static_cast<double>(z >> 11) * 0x1.0p-52 - 1.0;
}

double ease(double t) { return t * t * (3 - 2 * t); }

}  // namespace

double value_noise(std::uint64_t seed, double x, double y) {
  const double fx = std::floor(x), fy = std::floor(y);
  const auto column = static_cast<std::int64_t>(fx), row = static_cast<std::int64_t>(fy);
  const double u = ease(x - fx), v = ease(y - fy);
  const double low = (1 - u) * lattice(seed, column, row) + u * lattice(seed, column + 1, row);
  const double high =
      (1 - u) * lattice(seed, column, row + 1) + u * lattice(seed, column + 1, row + 1);
  return (1 - v) * low + v * high;
}

double fractal_noise(std::uint64_t seed, double x, double y) {
  return (value_noise(seed, x, y) + 0.5 * value_noise(seed + 1, 2 * x, 2 * y) +
          0.25 * value_noise(seed + 2, 4 * x, 4 * y)) /
         1.75;
}

}  // namespace stope::source
