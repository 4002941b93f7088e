#include "framework/executor/trace.hpp"

#include <algorithm>
#include <array>

namespace stope {

Trace::Trace(Clock::time_point run_begin, std::size_t limit)
    : run_begin_(run_begin), limit_(std::max<std::size_t>(limit, 64)) {}

std::int64_t Trace::now() const {
  return std::chrono::duration_cast<std::chrono::nanoseconds>(Clock::now() - run_begin_).count();
}

void Trace::begin_life() { life_begin_ = last_end_ = now(); }

void Trace::end_life() {
  life_end_ = now();
  if (life_end_ > last_end_) keep(Activity::kRun, last_end_, life_end_);
}

void Trace::add(Activity activity, std::int64_t begin) {
  const std::int64_t end = now();
  // A payload's loader may have loaded another: that time is counted already.
  begin = std::max(begin, last_end_);
  if (begin > last_end_) keep(Activity::kRun, last_end_, begin);
  keep(activity, begin, end);
  last_end_ = end;
}

void Trace::keep(Activity activity, std::int64_t begin, std::int64_t end) {
  sums_[static_cast<std::size_t>(activity)] += end - begin;
  spans_.push_back({activity, begin, end, end - begin, 1});
  if (spans_.size() >= limit_) aggregate();
}

void Trace::aggregate() {
  while (spans_.size() > limit_ / 2) {
    std::vector<Span> joined;
    for (std::size_t first = 0; first < spans_.size();) {
      const std::int64_t window = spans_[first].begin / window_;
      std::array<Span, 4> sums{};
      for (Span& sum : sums) sum.count = 0;
      for (; first < spans_.size() && spans_[first].begin / window_ == window; ++first) {
        const Span& span = spans_[first];
        Span& sum = sums[static_cast<std::size_t>(span.activity)];
        if (sum.count == 0) sum = {span.activity, span.begin, span.end, 0, 0};
        sum.end = std::max(sum.end, span.end);
        sum.busy += span.busy;
        sum.count += span.count;
      }
      std::sort(sums.begin(), sums.end(),
                [](const Span& a, const Span& b) { return a.begin < b.begin; });
      for (const Span& sum : sums) {
        if (sum.count != 0) joined.push_back(sum);
      }
    }
    spans_ = std::move(joined);
    window_ *= 2;
  }
}

void Trace::write(ProcessRecord& record) const {
  record.begin = life_begin_;
  record.end = life_end_;
  record.run = sums_[static_cast<std::size_t>(Activity::kRun)];
  record.wait_in = sums_[static_cast<std::size_t>(Activity::kWaitIn)];
  record.wait_out = sums_[static_cast<std::size_t>(Activity::kWaitOut)];
  record.io = sums_[static_cast<std::size_t>(Activity::kIo)];
  record.spans = spans_;
}

Trace*& Trace::of_this_thread() {
  thread_local Trace* trace = nullptr;
  return trace;
}

}  // namespace stope
