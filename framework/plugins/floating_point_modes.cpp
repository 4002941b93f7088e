#include "framework/plugins/floating_point_modes.hpp"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace stope {

#if defined(__x86_64__)

namespace {
constexpr std::uint32_t kStatusFlags = 0x3f;
}

FloatingPointModes floating_point_modes() {
  FloatingPointModes modes;
  modes.vector = _mm_getcsr() & ~kStatusFlags;
  __asm__ __volatile__("fnstcw %0" : "=m"(modes.x87));
  return modes;
}

void set_floating_point_modes(const FloatingPointModes& modes) {
  _mm_setcsr((_mm_getcsr() & kStatusFlags) | static_cast<std::uint32_t>(modes.vector));
  __asm__ __volatile__("fldcw %0" : : "m"(modes.x87));
}

#else

FloatingPointModes floating_point_modes() {
  FloatingPointModes modes;
  __asm__ __volatile__("mrs %0, fpcr" : "=r"(modes.vector));
  return modes;
}

void set_floating_point_modes(const FloatingPointModes& modes) {
  __asm__ __volatile__("msr fpcr, %0" : : "r"(modes.vector));
}

#endif

}  // namespace stope
