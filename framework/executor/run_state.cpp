#include "framework/executor/run_state.hpp"

namespace stope {

void RunState::fail(const std::string& stage, const std::string& sentence) {
  {
    const std::lock_guard lock(mutex_);
    if (stopping()) return;
    failures_.push_back({stage, sentence});
    if (go_on_ && !stage.empty()) return;
    stopping_.store(true);
  }
  wake_all();
}

void RunState::cancel() {
  {
    const std::lock_guard lock(mutex_);
    if (stopping()) return;
    cancelled_ = true;
    stopping_.store(true);
  }
  wake_all();
}

void RunState::wake_all() {
  for (Doorbell* doorbell : doorbells_) doorbell->ring();
}

void RunState::record(RunRecord& record) const {
  const std::lock_guard lock(mutex_);
  record.failures = failures_;
  record.stopped = stopping();
  if (cancelled_) {
    record.end = RunRecord::End::kCancelled;
  } else if (!failures_.empty()) {
    record.end = RunRecord::End::kFailed;
    record.sentence = failures_.front().sentence;
    record.failed_stage = failures_.front().stage;
  }
}

}  // namespace stope
