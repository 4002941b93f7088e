#include "framework/executor/map_process.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "framework/executor/item_text.hpp"

namespace stope {

namespace {

/// Enough for one wake-up to serve several small items, and for every worker to find work while the
/// oldest item is slow.
std::size_t places_for(const StageInfo& info, int threads) {
  if (info.in_order) return 1;
  return std::max<std::size_t>(16, 2 * static_cast<std::size_t>(threads));
}

}  // namespace

MapProcess::MapProcess(const PlannedStage& stage, const RunServices& services,
                       std::unique_ptr<StageInstance> instance)
    : Process(stage.name, services),
      pool_(services.pool),
      context_(*this, stage.seed_name(), services),
      instance_(std::move(instance)),
      most_bytes_(services.store.bytes_of_a_window()) {}

Outcome MapProcess::work() {
  open();
  hold_values();
  const Outcome read = guarded([&] {
    if (streams_.empty()) {
      window_->submit();
    } else {
      while (read_step()) window_->submit();
    }
  });
  // Also after an error while reading: an item before it may have failed, and the lowest index
  // wins.
  const Outcome written = guarded([&] {
    while (!window_->empty()) {
      wait_for_oldest();
      write_done();
    }
  });
  window_->stop();
  return written ? read : written;
}

void MapProcess::open() {
  window_ = std::make_shared<MapWindow>(pool_, shared_doorbell(),
                                        places_for(instance_->info(), pool_.threads()),
                                        [this](MapItem& item) { apply(item); });
  for (MapItem* item : window_->all()) {
    item->inputs.resize(inputs().size());
    item->outputs.resize(outputs().size());
  }
  for (std::size_t port = 0; port < inputs().size(); ++port) {
    if (inputs()[port]->wired() && inputs()[port]->stream()) streams_.push_back(port);
  }
}

void MapProcess::hold_values() {
  for (std::size_t port = 0; port < inputs().size(); ++port) {
    if (!inputs()[port]->wired() || inputs()[port]->stream()) continue;
    const AnyItem value = inputs()[port]->next();
    if (!value)
      throw Error(fmt::format("its input \"{}\" ended without giving a value",
                              instance_->info().inputs[port].name));
    held_values_.push_back(value.payload->pin());
    for (MapItem* item : window_->all()) item->inputs[port] = value;
  }
}

bool MapProcess::read_step() {
  while (full()) {
    wait_for_oldest();
    write_done();
  }
  MapItem& item = window_->newest();
  std::size_t ended = 0;
  for (const std::size_t port : streams_) {
    item.inputs[port] = next(*inputs()[port]);
    if (!item.inputs[port]) ++ended;
  }
  if (ended == streams_.size()) return false;
  for (const std::size_t port : streams_) require_equal_stamps(item, port);
  item.stamp = item.inputs[streams_[0]].stamp;
  item.index = item.inputs[streams_[0]].index;
  return true;
}

void MapProcess::require_equal_stamps(const MapItem& item, std::size_t port) const {
  const std::size_t first = streams_[0];
  const AnyItem& a = item.inputs[first];
  const AnyItem& b = item.inputs[port];
  if (a && b && a.stamp == b.stamp) return;
  const std::string& a_name = instance_->info().inputs[first].name;
  const std::string& b_name = instance_->info().inputs[port].name;
  if (a && b)
    throw Error(
        fmt::format("its inputs do not run in step: \"{}\" is at {}, \"{}\" at {}; streams "
                    "that a map reads must carry equal stamps",
                    a_name, time_text(a.stamp), b_name, time_text(b.stamp)));
  throw Error(
      fmt::format("its inputs do not run in step: \"{}\" has ended while \"{}\" is at {}; "
                  "streams that a map reads must end together",
                  a ? b_name : a_name, a ? a_name : b_name, time_text(a ? a.stamp : b.stamp)));
}

AnyItem MapProcess::next(InputEnd& input) {
  for (;;) {
    if (stopping()) throw Cancelled();
    AnyItem item = input.try_next();
    if (item) return item;
    if (input.ended()) {
      input.require_whole();
      return {};
    }
    if (write_done()) continue;
    if (window_->empty()) {
      wait_to_read(*input.channel());
      continue;
    }
    // Not a wait in the sense of the WaitGraph: the workers will ring.
    wake_writers();
    input.channel()->set_reader_waits(true);
    doorbell().prepare();
    if (!input.channel()->readable() && !window_->oldest_done() && !stopping()) doorbell().sleep();
    doorbell().dismiss();
    input.channel()->set_reader_waits(false);
  }
}

bool MapProcess::full() const {
  return window_->full() || (window_->size() >= static_cast<std::size_t>(pool_.threads()) &&
                             unwritten_bytes_.load() > most_bytes_);
}

void MapProcess::wait_for_oldest() {
  if (window_->oldest_done()) return;
  wake_writers();
  for (;;) {
    doorbell().prepare();
    if (window_->oldest_done() || stopping()) break;
    doorbell().sleep();
  }
  doorbell().dismiss();
  if (stopping()) throw Cancelled();
}

bool MapProcess::write_done() {
  bool wrote = false;
  while (window_->oldest_done()) {
    MapItem& item = window_->oldest();
    if (!item.outcome) {
      set_item({item.stamp, item.index, nullptr});
      if (item.outcome.kind == Outcome::Kind::kCancelled) throw Cancelled();
      throw Error(item.outcome.sentence);
    }
    work_ += item.work;
    written_.swap(item.outputs);
    item.outputs.resize(written_.size());
    const Stamp stamp = item.stamp;
    const std::uint64_t index = item.index;
    window_->advance();
    for (std::size_t port = 0; port < written_.size(); ++port) {
      if (written_[port]) unwritten_bytes_.fetch_sub(written_[port]->bytes());
      outputs()[port]->put(stamp, index, std::move(written_[port]));
    }
    wrote = true;
  }
  return wrote;
}

void MapProcess::apply(MapItem& item) {
  const std::int64_t begin = trace().now();
  Outcome applied;
  const Outcome kept = guarded([&] {
    context_.stop_if_cancelled();
    ItemContext context(context_, item.index, item.stamp);
    std::vector<std::shared_ptr<const void>> made(outputs().size());
    applied = instance_->apply(item.inputs, context, made);
    for (const std::size_t port : streams_) item.inputs[port] = {};
    if (!applied) return;
    for (std::size_t port = 0; port < made.size(); ++port) {
      if (!outputs()[port]->wanted()) continue;
      item.outputs[port] = outputs()[port]->make_payload(std::move(made[port]));
      unwritten_bytes_.fetch_add(item.outputs[port]->bytes());
    }
  });
  item.outcome = kept ? applied : kept;
  item.work = trace().now() - begin;
}

void MapProcess::release() {
  window_.reset();
  held_values_.clear();
  instance_.reset();
}

}  // namespace stope
