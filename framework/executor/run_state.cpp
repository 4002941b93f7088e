#include "framework/executor/run_state.hpp"

namespace stope {

void RunState::fail(const std::string& stage, const std::string& sentence) {
  stop(RunRecord::End::kFailed, stage, sentence);
}

void RunState::cancel() { stop(RunRecord::End::kCancelled, {}, {}); }

void RunState::stop(RunRecord::End end, const std::string& stage, const std::string& sentence) {
  {
    const std::lock_guard lock(mutex_);
    if (end_ != RunRecord::End::kDone) return;
    end_ = end;
    failed_stage_ = stage;
    sentence_ = sentence;
  }
  stopping_.store(true);
  for (Doorbell* doorbell : doorbells_) doorbell->ring();
}

RunRecord::End RunState::end() const {
  const std::lock_guard lock(mutex_);
  return end_;
}

std::string RunState::failed_stage() const {
  const std::lock_guard lock(mutex_);
  return failed_stage_;
}

std::string RunState::sentence() const {
  const std::lock_guard lock(mutex_);
  return sentence_;
}

}  // namespace stope
