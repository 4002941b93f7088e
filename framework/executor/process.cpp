#include "framework/executor/process.hpp"

#include <fmt/format.h>
#include <pthread.h>

#include <utility>

#include "framework/executor/item_text.hpp"

namespace stope {

Process::Process(std::string name, const RunServices& services)
    : name_(std::move(name)),
      state_(services.state),
      waits_(services.waits),
      trace_(services.begin, services.span_limit) {
  state_.add(*doorbell_);
}

void Process::start() {
  thread_ = std::thread([this] { live(); });
}

void Process::join() {
  if (thread_.joinable()) thread_.join();
}

void Process::live() {
  pthread_setname_np(pthread_self(), name_.substr(0, 15).c_str());
  trace_.begin_life();
  Trace::of_this_thread() = &trace_;
  Outcome outcome;
  const Outcome caught = guarded([&] { outcome = work(); });
  settle(caught ? outcome : caught);
  guarded([&] { release(); });
  Trace::of_this_thread() = nullptr;
  trace_.end_life();
  finished_.store(true);
}

void Process::settle(const Outcome& outcome) {
  const bool whole = succeeded(outcome);
  for (const auto& output : outputs_) {
    if (whole)
      output->close();
    else
      output->break_off();
  }
  for (const auto& input : inputs_) input->leave();
}

bool Process::succeeded(const Outcome& outcome) {
  if (outcome.kind == Outcome::Kind::kFailed) {
    fail(place_text(), outcome.sentence);
    return false;
  }
  if (outcome.kind == Outcome::Kind::kCancelled) {
    if (!stopping() && !gave_up_)
      fail(place_text(), "it gave up as if the run had been cancelled, which it was not");
    return false;
  }
  bool all_set = true;
  for (const auto& output : outputs_) {
    if (output->stream() || !output->wanted() || output->given()) continue;
    all_set = false;
    fail("",
         fmt::format("it ended without setting its output \"{}\", which is read", output->name()));
  }
  return all_set;
}

void Process::fail(const std::string& where, const std::string& what) {
  state_.fail(name_, where.empty() ? fmt::format("stage \"{}\" failed: {}", name_, what)
                                   : fmt::format("stage \"{}\" failed {}: {}", name_, where, what));
}

void Process::wait_to_read(Channel& channel) {
  const std::int64_t begin = trace_.now();
  wake_writers();
  if (patience_.wait_for([&] { return channel.readable() || stopping(); })) {
    trace_.add(Activity::kWaitIn, begin);
    if (stopping()) throw Cancelled();
    return;
  }
  channel.set_reader_waits(true);
  for (;;) {
    doorbell_->prepare();
    if (channel.readable() || stopping()) break;
    waits_.enter(*this, channel);
    doorbell_->sleep();
    WaitGraph::leave(*this);
  }
  doorbell_->dismiss();
  channel.set_reader_waits(false);
  trace_.add(Activity::kWaitIn, begin);
  if (stopping()) throw Cancelled();
}

void Process::wait_to_write(Channel& channel) {
  const std::int64_t begin = trace_.now();
  wake_writers();
  if (patience_.wait_for([&] { return channel.writable() || stopping(); })) {
    trace_.add(Activity::kWaitOut, begin);
    if (stopping()) throw Cancelled();
    return;
  }
  channel.set_writer_waits(true);
  for (;;) {
    doorbell_->prepare();
    if (channel.writable() || stopping()) break;
    waits_.enter(*this, channel);
    doorbell_->sleep();
    WaitGraph::leave(*this);
  }
  doorbell_->dismiss();
  channel.set_writer_waits(false);
  trace_.add(Activity::kWaitOut, begin);
  if (stopping()) throw Cancelled();
}

void Process::wake_writers() {
  for (const auto& input : inputs_) {
    if (Channel* channel = input->channel()) channel->wake_writer();
  }
}

void Process::give_up() {
  gave_up_ = true;
  throw Cancelled();
}

void Process::set_item(const AnyItem& item) {
  item_stamp_.store(item.stamp, std::memory_order_relaxed);
  item_index_.store(item.index, std::memory_order_relaxed);
  has_item_.store(true, std::memory_order_relaxed);
}

std::string Process::item_text() const {
  if (!has_item_.load()) return {};
  return stope::item_text(item_index_.load(), item_stamp_.load());
}

std::string Process::place_text() const {
  if (const std::string item = item_text(); !item.empty()) return "at " + item;
  for (const auto& output : outputs_) {
    if (output->stream() && output->given()) return "after " + output->last_text();
  }
  return {};
}

std::uint64_t Process::items_read() const {
  std::uint64_t sum = 0;
  for (const auto& input : inputs_) sum += input->items();
  return sum;
}

std::uint64_t Process::items_written() const {
  std::uint64_t sum = 0;
  for (const auto& output : outputs_) sum += output->items();
  return sum;
}

ProcessRecord Process::record() const {
  ProcessRecord record;
  record.name = name_;
  trace_.write(record);
  record.work = work_elsewhere();
  record.items_read = items_read();
  record.items_written = items_written();
  return record;
}

}  // namespace stope
