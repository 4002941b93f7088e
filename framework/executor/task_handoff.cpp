#include "framework/executor/task_handoff.hpp"

#if defined(__has_feature)
#if __has_feature(thread_sanitizer)
#include <sanitizer/tsan_interface.h>
#endif
#elif defined(__SANITIZE_THREAD__)
#include <sanitizer/tsan_interface.h>
#endif

namespace stope {

#ifdef TSAN_INTERFACE_H
void hand_over(const void* object) { __tsan_release(const_cast<void*>(object)); }
void take_over(const void* object) { __tsan_acquire(const_cast<void*>(object)); }
#else
void hand_over(const void*) {}
void take_over(const void*) {}
#endif

}  // namespace stope
