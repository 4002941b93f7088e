#pragma once

namespace stope {

/// Tell ThreadSanitizer what it cannot see for itself: oneTBB is not compiled with it, so a task's
/// way from the thread that submits it to the one that runs it looks like a race. Without
/// ThreadSanitizer these do nothing.
///
/// What this thread wrote so far is visible to whoever takes `object` over.
void hand_over(const void* object);
void take_over(const void* object);

}  // namespace stope
