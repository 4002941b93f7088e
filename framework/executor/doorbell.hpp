#pragma once

#include <atomic>
#include <cstdint>

namespace stope {

/// What a process sleeps on. One owner sleeps, anyone rings. The owner says prepare(), looks once
/// more at what it waits for, and sleeps; whoever changes that first publishes the change and then
/// rings. All of it is sequentially consistent, so that no ring can fall between the look and the
/// sleep. A ring costs one load while the owner is awake.
class Doorbell {
 public:
  /// Of the owner: from here on a ring is heard.
  void prepare() { asleep_.store(1); }
  /// Of the owner: no need to sleep after all.
  void dismiss() { asleep_.store(0, std::memory_order_relaxed); }
  /// Of the owner: sleeps until a ring since prepare().
  void sleep() { asleep_.wait(1); }
  /// Of anyone.
  void ring() {
    if (asleep_.load() == 1 && asleep_.exchange(0) == 1) asleep_.notify_one();
  }

 private:
  alignas(64) std::atomic<std::int32_t> asleep_{0};
};

}  // namespace stope
