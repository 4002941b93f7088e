#pragma once

#include <atomic>
#include <memory>
#include <utility>

#include "stope/payload.hpp"

namespace stope {

/// One item of a stream, or none (the stream has ended). The payload is brought into memory when it
/// is first touched and stays there until the item dies. Several threads may touch one item.
template <class T>
class Item {
 public:
  Item() = default;
  explicit Item(AnyItem any) : any_(std::move(any)) {}
  Item(const Item& other) : any_(other.any_) {}
  Item(Item&& other) noexcept
      : any_(std::move(other.any_)),
        pinned_(std::move(other.pinned_)),
        state_(other.state_.exchange(kUntouched)) {}
  Item& operator=(Item other) noexcept {
    any_ = std::move(other.any_);
    pinned_ = std::move(other.pinned_);
    state_ = other.state_.load();
    return *this;
  }
  ~Item() = default;

  explicit operator bool() const { return static_cast<bool>(any_); }
  Stamp stamp() const { return any_.stamp; }
  std::uint64_t index() const { return any_.index; }

  const T& operator*() const { return *static_cast<const T*>(touch().get()); }
  const T* operator->() const { return &**this; }
  /// The value with shared ownership: it may outlive the item.
  std::shared_ptr<const T> share() const { return std::static_pointer_cast<const T>(touch()); }
  const AnyItem& any() const { return any_; }

 private:
  enum State : int { kUntouched, kLoading, kReady };

  const std::shared_ptr<const void>& touch() const {
    for (;;) {
      int seen = state_.load(std::memory_order_acquire);
      if (seen == kReady) return pinned_;
      if (seen == kLoading) {
        state_.wait(kLoading);
        continue;
      }
      if (!state_.compare_exchange_strong(seen, kLoading)) continue;
      try {
        pinned_ = any_.payload->pin();
      } catch (...) {
        state_ = kUntouched;
        state_.notify_all();
        throw;
      }
      state_.store(kReady, std::memory_order_release);
      state_.notify_all();
      return pinned_;
    }
  }

  AnyItem any_;
  mutable std::shared_ptr<const void> pinned_;
  mutable std::atomic<int> state_{kUntouched};
};

}  // namespace stope
