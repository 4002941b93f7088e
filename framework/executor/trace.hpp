#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "framework/executor/run_record.hpp"

namespace stope {

/// How a process spends its life. It tells when it waits or reads and writes files; the rest is
/// running. So the spans cover its life without gaps, and a clock is read only when it blocks.
///
/// At most `limit` spans are kept: when there are more, those that begin within the same short time
/// are joined, one for each activity, and that time doubles as often as needed.
class Trace {
 public:
  using Clock = std::chrono::steady_clock;

  Trace(Clock::time_point run_begin, std::size_t limit);

  /// Nanoseconds since the run began.
  std::int64_t now() const;
  void begin_life();
  void end_life();
  /// Of the process's own thread: it did `activity` from `begin` until now.
  void add(Activity activity, std::int64_t begin);

  /// After the process's life: fills times and spans.
  void write(ProcessRecord& record) const;

  /// The trace of the process whose thread this is, or null on a thread that belongs to oneTBB. A
  /// payload is touched without saying by whom; this is how its loading is put down to the right
  /// process.
  static Trace*& of_this_thread();

 private:
  void keep(Activity activity, std::int64_t begin, std::int64_t end);
  void aggregate();

  Clock::time_point run_begin_;
  std::size_t limit_;
  std::int64_t life_begin_ = 0, life_end_ = 0, last_end_ = 0;
  std::int64_t sums_[4] = {};
  std::int64_t window_ = 1'000'000;
  std::vector<Span> spans_;
};

/// Puts the time from its making to its end down to input and output of this thread's process.
class IoSpan {
 public:
  IoSpan() : trace_(Trace::of_this_thread()), begin_(trace_ ? trace_->now() : 0) {}
  ~IoSpan() {
    if (trace_) trace_->add(Activity::kIo, begin_);
  }
  IoSpan(const IoSpan&) = delete;
  IoSpan& operator=(const IoSpan&) = delete;

 private:
  Trace* trace_;
  std::int64_t begin_;
};

}  // namespace stope
