#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <utility>

#include "stope/payload.hpp"

namespace stope {

/// A queue for one writer and one reader that never locks and never moves an item in memory: a list
/// of small blocks. How many items it may hold is for the channel to say, so growing costs nothing.
class ItemQueue {
 public:
  ItemQueue() : oldest_(std::make_unique<Block>()), newest_(oldest_.get()) {}
  ItemQueue(const ItemQueue&) = delete;
  ItemQueue& operator=(const ItemQueue&) = delete;
  ~ItemQueue() {
    // One by one: a long list must not be destroyed by recursion.
    while (oldest_) oldest_ = std::exchange(oldest_->next, nullptr);
  }

  /// Of the writer.
  void push(AnyItem item) {
    const std::uint64_t place = written_.load(std::memory_order_relaxed);
    if (place != 0 && place % kBlock == 0) {
      newest_->next = std::make_unique<Block>();
      newest_ = newest_->next.get();
    }
    newest_->items[place % kBlock] = std::move(item);
    written_.store(place + 1);
  }

  /// Of the reader, of a queue that is not empty.
  AnyItem pop() {
    const std::uint64_t place = read_.load(std::memory_order_relaxed);
    if (place != 0 && place % kBlock == 0) oldest_ = std::exchange(oldest_->next, nullptr);
    AnyItem item = std::move(oldest_->items[place % kBlock]);
    read_.store(place + 1);
    return item;
  }

  /// Items written so far, and items read so far. Each is exact for the side that counts it.
  std::uint64_t written() const { return written_.load(); }
  std::uint64_t read() const { return read_.load(); }
  std::size_t size() const {
    const std::uint64_t read = read_.load();
    return static_cast<std::size_t>(written_.load() - read);
  }

 private:
  static constexpr std::size_t kBlock = 16;
  struct Block {
    std::array<AnyItem, kBlock> items;
    std::unique_ptr<Block> next;
  };

  alignas(64) std::atomic<std::uint64_t> read_{0};
  std::unique_ptr<Block> oldest_;
  alignas(64) std::atomic<std::uint64_t> written_{0};
  Block* newest_;
};

}  // namespace stope
