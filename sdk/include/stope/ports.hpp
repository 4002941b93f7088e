#pragma once

#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "stope/error.hpp"
#include "stope/item.hpp"

namespace stope {

/// The framework's end of an input: where In and InValue get their items from.
class STOPE_API InputPort {
 public:
  virtual ~InputPort() = default;
  /// The next item, or an empty one after the last. Waits. Throws Cancelled when the run stops.
  virtual AnyItem next() = 0;
};

/// The framework's end of an output: where Out and OutValue put their items.
class STOPE_API OutputPort {
 public:
  virtual ~OutputPort() = default;
  /// Whether any stage or output reads this port. If not, put() drops the item: skip the work.
  virtual bool wanted() const = 0;
  /// Writes an item; waits while the channel is full. Without an index the item follows the
  /// previous one. Throws Error if the stamp decreases or the index does not increase, Cancelled
  /// when the run stops.
  virtual void put(Stamp stamp, std::optional<std::uint64_t> index,
                   std::shared_ptr<const void> value) = 0;
  /// Writes an item whose value is made by `load` when it is touched; `bytes` is what it will about
  /// take in memory.
  virtual void put_lazy(Stamp stamp, std::optional<std::uint64_t> index, PayloadLoader load,
                        std::size_t bytes) = 0;
};

/// A stream of items, read in order. Not wired (an optional input): it ends at once.
template <PayloadStruct T>
class In {
 public:
  using Value = T;
  static constexpr bool kStream = true;

  /// The next item, or an empty one after the last. Waits. Throws Cancelled when the run stops.
  Item<T> next() {
    if (ahead_) return std::exchange(ahead_, std::nullopt).value();
    return port_ ? Item<T>(port_->next()) : Item<T>();
  }
  /// All following items up to and including those with this stamp. Joins two streams in time
  /// order.
  std::vector<Item<T>> until(Stamp stamp) {
    std::vector<Item<T>> items;
    for (;;) {
      Item<T> item = next();
      if (!item) return items;
      if (item.stamp() > stamp) {
        ahead_ = std::move(item);
        return items;
      }
      items.push_back(std::move(item));
    }
  }
  bool wired() const { return port_ != nullptr; }
  void connect(InputPort* port) { port_ = port; }

 private:
  InputPort* port_ = nullptr;
  std::optional<Item<T>> ahead_;
};

/// An input that carries exactly one item.
template <PayloadStruct T>
class InValue {
 public:
  using Value = T;
  static constexpr bool kStream = false;

  /// The value. Waits for it the first time. Throws Cancelled when the run stops, Error if it was
  /// not wired.
  const T& get() {
    if (!item_) {
      if (!port_) throw Error("this input is not wired: ask wired() before get()");
      item_ = Item<T>(port_->next());
      if (!item_) throw Error("the stage that should give this value ended without giving it");
    }
    return *item_;
  }
  bool wired() const { return port_ != nullptr; }
  void connect(InputPort* port) { port_ = port; }

 private:
  InputPort* port_ = nullptr;
  Item<T> item_;
};

/// A stream of items to write.
template <PayloadStruct T>
class Out {
 public:
  using Value = T;
  static constexpr bool kStream = true;

  /// Whether anyone reads this output. If not, the work for it can be skipped.
  bool wanted() const { return port_ && port_->wanted(); }
  /// Writes the next item. Waits while the channel is full. See OutputPort::put for its errors.
  void put(Stamp stamp, T value, std::optional<std::uint64_t> index = std::nullopt) {
    if (port_) port_->put(stamp, index, std::make_shared<const T>(std::move(value)));
  }
  void put(Stamp stamp, std::shared_ptr<const T> value,
           std::optional<std::uint64_t> index = std::nullopt) {
    if (port_) port_->put(stamp, index, std::move(value));
  }
  /// Writes an item that `load` (a function giving a T, the same each time) makes when someone
  /// touches it.
  template <class Load>
  void put_lazy(Stamp stamp, Load load, std::size_t bytes,
                std::optional<std::uint64_t> index = std::nullopt) {
    if (!port_) return;
    port_->put_lazy(
        stamp, index,
        [load = std::move(load)]() -> std::shared_ptr<const void> {
          return std::make_shared<const T>(load());
        },
        bytes);
  }
  void connect(OutputPort* port) { port_ = port; }

 private:
  OutputPort* port_ = nullptr;
};

/// An output that carries exactly one item: set() it once before run() returns.
template <PayloadStruct T>
class OutValue {
 public:
  using Value = T;
  static constexpr bool kStream = false;

  bool wanted() const { return port_ && port_->wanted(); }
  void set(T value, Stamp stamp = 0) {
    if (port_) port_->put(stamp, 0, std::make_shared<const T>(std::move(value)));
  }
  void connect(OutputPort* port) { port_ = port; }

 private:
  OutputPort* port_ = nullptr;
};

/// In a Map's signature: an input that may be left unwired. Null then.
template <PayloadStruct T>
class Optional {
 public:
  Optional() = default;
  explicit Optional(const T* value) : value_(value) {}
  explicit operator bool() const { return value_ != nullptr; }
  const T& operator*() const { return *value_; }
  const T* operator->() const { return value_; }

 private:
  const T* value_ = nullptr;
};

}  // namespace stope
