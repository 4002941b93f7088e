#pragma once

#include <deque>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "stope/ports.hpp"

namespace stope::testing {

/// A payload that simply is in memory.
template <class T>
class MemoryPayload final : public Payload {
 public:
  explicit MemoryPayload(std::shared_ptr<const void> value) : value_(std::move(value)) {}
  const PayloadType& type() const noexcept override { return payload_type<T>(); }
  std::shared_ptr<const void> pin() override { return value_; }

 private:
  std::shared_ptr<const void> value_;
};

/// An input that gives prepared items: `MemoryInput<LidarScan> input; input.add(stamp, scan);
/// stage.scans.connect(&input);`
template <class T>
class MemoryInput final : public InputPort {
 public:
  void add(Stamp stamp, T value) {
    items_.push_back(
        {stamp, count_++,
         std::make_shared<MemoryPayload<T>>(std::make_shared<const T>(std::move(value)))});
  }
  AnyItem next() override {
    if (items_.empty()) return {};
    AnyItem item = std::move(items_.front());
    items_.pop_front();
    return item;
  }

 private:
  std::deque<AnyItem> items_;
  std::uint64_t count_ = 0;
};

/// An output that keeps what a stage writes.
template <class T>
class MemoryOutput final : public OutputPort {
 public:
  struct Entry {
    Stamp stamp;
    std::uint64_t index;
    std::shared_ptr<const T> value;
  };
  bool wanted() const override { return true; }
  void put(Stamp stamp, std::optional<std::uint64_t> index,
           std::shared_ptr<const void> value) override {
    const std::uint64_t next = items.empty() ? 0 : items.back().index + 1;
    items.push_back({stamp, index.value_or(next), std::static_pointer_cast<const T>(value)});
  }
  void put_lazy(Stamp stamp, std::optional<std::uint64_t> index, PayloadLoader load,
                std::size_t) override {
    put(stamp, index, load());
  }
  std::vector<Entry> items;
};

}  // namespace stope::testing
