#pragma once

#include <cstdint>

namespace stope {

/// How this thread's processor rounds and treats tiny numbers and floating-point exceptions. Status
/// flags are left out. A library built with -ffast-math changes it for whoever loads it.
struct FloatingPointModes {
  std::uint64_t vector = 0;  ///< MXCSR, or FPCR on ARM
  std::uint16_t x87 = 0;     ///< x87 control word
  bool operator==(const FloatingPointModes&) const = default;
};

FloatingPointModes floating_point_modes();
void set_floating_point_modes(const FloatingPointModes& modes);

}  // namespace stope
