#include "framework/executor/task_handoff.hpp"

#if defined(__has_feature)
#if __has_feature(thread_sanitizer)
#include <sanitizer/tsan_interface.h>
#endif
#elif defined(__SANITIZE_THREAD__)
#include <sanitizer/tsan_interface.h>
#endif

#ifdef SANITIZER_TSAN_INTERFACE_H
/// What oneTBB does among its own threads is not ours to judge. ThreadSanitizer asks for this name.
extern "C" const char* __tsan_default_suppressions();
extern "C" const char* __tsan_default_suppressions() { return "race:libtbb.so"; }
#endif

namespace stope {

#ifdef SANITIZER_TSAN_INTERFACE_H
void hand_over(const void* object) { __tsan_release(const_cast<void*>(object)); }
void take_over(const void* object) { __tsan_acquire(const_cast<void*>(object)); }
#else
void hand_over(const void*) {}
void take_over(const void*) {}
#endif

}  // namespace stope
