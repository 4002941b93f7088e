#include "framework/executor/output_end.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "framework/executor/item_text.hpp"
#include "framework/executor/process.hpp"

namespace stope {

OutputEnd::OutputEnd(Process& process, PayloadStore& store, const PayloadType& type,
                     std::string name, bool stream)
    : process_(process),
      store_(store),
      shelf_(store.add_shelf()),
      type_(type),
      name_(std::move(name)),
      stream_(stream) {}

void OutputEnd::wire(Channel& channel) {
  channels_.push_back(&channel);
  shelf_.add_reader(channel);
}

void OutputEnd::put(Stamp stamp, std::optional<std::uint64_t> index,
                    std::shared_ptr<const void> value) {
  const std::uint64_t place = check(stamp, index);
  if (!value) throw Error(fmt::format("output \"{}\" was given an item without a value", name_));
  if (wanted()) send(stamp, place, make_payload(std::move(value)));
}

void OutputEnd::put_lazy(Stamp stamp, std::optional<std::uint64_t> index, PayloadLoader load,
                         std::size_t bytes) {
  const std::uint64_t place = check(stamp, index);
  if (!load)
    throw Error(fmt::format("output \"{}\" was given a lazy item without a loader", name_));
  if (wanted()) send(stamp, place, store_.keep_lazy(type_, std::move(load), bytes, shelf_));
}

std::shared_ptr<RunPayload> OutputEnd::make_payload(std::shared_ptr<const void> value) {
  return store_.keep(type_, std::move(value), shelf_);
}

void OutputEnd::put(Stamp stamp, std::uint64_t index, std::shared_ptr<RunPayload> payload) {
  check(stamp, index);
  if (wanted()) send(stamp, index, std::move(payload));
}

std::uint64_t OutputEnd::check(Stamp stamp, std::optional<std::uint64_t> index) {
  if (process_.stopping()) throw Cancelled();
  const std::uint64_t place = index.value_or(last_index_ ? *last_index_ + 1 : 0);
  if (last_index_) {
    if (!stream_)
      throw Error(fmt::format("output \"{}\" is a value and was set twice: set it once", name_));
    if (stamp < last_stamp_)
      throw Error(
          fmt::format("output \"{}\" goes back in time, from {} to {}: stamps of a stream "
                      "must never decrease",
                      name_, item_text(*last_index_, last_stamp_), item_text(place, stamp)));
    if (place <= *last_index_)
      throw Error(
          fmt::format("output \"{}\" goes from index {} to {}: indices of a stream must "
                      "increase",
                      name_, *last_index_, place));
  }
  last_stamp_ = stamp;
  last_index_ = place;
  return place;
}

void OutputEnd::send(Stamp stamp, std::uint64_t index, std::shared_ptr<RunPayload> payload) {
  payload->set_place(items());
  AnyItem item{stamp, index, std::move(payload)};
  bool lost_reader = false;
  for (std::size_t i = 0; i < channels_.size(); ++i) {
    Channel& channel = *channels_[i];
    if (channel.full()) process_.wait_to_write(channel);
    lost_reader |= channel.abandoned();
    if (i + 1 < channels_.size()) {
      channel.push(item);
    } else {
      channel.push(std::move(item));
    }
  }
  items_.store(items() + 1, std::memory_order_relaxed);
  if (!lost_reader) return;
  for (const auto& output : process_.outputs()) {
    if (output->wanted() && !output->abandoned()) return;
  }
  process_.give_up();
}

bool OutputEnd::abandoned() const {
  return wanted() && std::all_of(channels_.begin(), channels_.end(),
                                 [](const Channel* channel) { return channel->abandoned(); });
}

std::string OutputEnd::last_text() const { return item_text(*last_index_, last_stamp_); }

void OutputEnd::close() {
  for (Channel* channel : channels_) channel->close();
}

void OutputEnd::break_off() {
  for (Channel* channel : channels_) channel->break_off();
}

}  // namespace stope
