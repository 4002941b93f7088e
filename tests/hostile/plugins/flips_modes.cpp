// Flushes subnormal numbers to zero in whoever loads it, as -ffast-math does, though it was not
// compiled with it.
#if defined(__x86_64__)
#include <immintrin.h>

__attribute__((constructor)) static void flip() { _mm_setcsr(_mm_getcsr() | 0x8040); }
#else
__attribute__((constructor)) static void flip() {
  unsigned long modes;
  __asm__ __volatile__("mrs %0, fpcr" : "=r"(modes));
  __asm__ __volatile__("msr fpcr, %0" : : "r"(modes | (1UL << 24)));
}
#endif
