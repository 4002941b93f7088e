#pragma once

#include <memory>

namespace stope {

/// The part of oneTBB that the executor uses, behind plain functions and pointers: oneTBB is not
/// compiled with ThreadSanitizer, and neither is this class, so that nothing of it looks like a
/// race. See task_handoff.hpp.
class TbbArena {
 public:
  explicit TbbArena(int workers);
  ~TbbArena();
  TbbArena(const TbbArena&) = delete;
  TbbArena& operator=(const TbbArena&) = delete;

  /// Calls `run(argument)` once on some worker.
  void enqueue(void (*run)(void*), void* argument);
  /// Calls `run(argument)` here; while it waits for parallel work, this thread takes no other task.
  static void isolate(void (*run)(void*), void* argument);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace stope
