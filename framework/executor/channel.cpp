#include "framework/executor/channel.hpp"

#include <utility>

#include "framework/executor/process.hpp"

namespace stope {

Channel::Channel(std::string from, std::string to, std::size_t capacity, Process& writer,
                 Process& reader)
    : capacity_(capacity == 0 ? 1 : capacity),
      writer_(writer),
      reader_(reader),
      writer_bell_(writer.doorbell()),
      reader_bell_(reader.doorbell()),
      from_(std::move(from)),
      to_(std::move(to)) {}

void Channel::push(AnyItem item) {
  if (abandoned_.load()) return;
  queue_.push(std::move(item));
  if (reader_waits_.load()) reader_bell_.ring();
}

void Channel::close() {
  closed_.store(true);
  if (reader_waits_.load()) reader_bell_.ring();
}

void Channel::break_off() {
  broken_.store(true);
  close();
}

AnyItem Channel::pop() {
  if (empty()) return {};
  AnyItem item = queue_.pop();
  if (writer_waits_.load() && queue_.size() <= capacity() / 2) writer_bell_.ring();
  return item;
}

void Channel::abandon() {
  abandoned_.store(true);
  // An item may still slip in behind this; it stays until the run ends.
  while (!empty()) queue_.pop();
  wake_writer();
}

void Channel::wake_writer() {
  if (writer_waits_.load()) writer_bell_.ring();
}

void Channel::grow() {
  capacity_.store(capacity() * 2);
  growths_.fetch_add(1);
  writer_bell_.ring();
}

ChannelRecord Channel::record() const {
  return {from_, to_, queue_.written(), capacity(), growths_.load()};
}

}  // namespace stope
