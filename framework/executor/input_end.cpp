#include "framework/executor/input_end.hpp"

#include "framework/executor/process.hpp"

namespace stope {

AnyItem InputEnd::next() {
  if (!channel_) return {};
  if (process_.stopping()) throw Cancelled();
  AnyItem item = try_next();
  if (!item && !ended()) {
    process_.wait_to_read(*channel_);
    item = try_next();
  }
  if (!item) require_whole();
  return item;
}

void InputEnd::require_whole() const {
  if (channel_ && channel_->broken()) process_.give_up();
}

AnyItem InputEnd::try_next() {
  AnyItem item = channel_->pop();
  if (item) {
    process_.set_item(item);
    items_.store(items_.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
  }
  return item;
}

void InputEnd::leave() {
  if (channel_) channel_->abandon();
}

}  // namespace stope
