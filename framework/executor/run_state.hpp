#pragma once

#include <atomic>
#include <mutex>
#include <string>
#include <vector>

#include "framework/executor/doorbell.hpp"
#include "framework/executor/run_record.hpp"

namespace stope {

/// Whether the run goes on, and if not, why. The first reason to stop is the one that counts.
class RunState {
 public:
  /// `go_on`: whether the failure of a stage leaves the others running.
  explicit RunState(bool go_on) : go_on_(go_on) {}

  /// A process to wake when the run stops. Before the run begins.
  void add(Doorbell& doorbell) { doorbells_.push_back(&doorbell); }

  bool stopping() const { return stopping_.load(std::memory_order_acquire); }
  /// An error. `sentence` names stage, item and time. Stops the run unless it is to go on; one of
  /// the run itself, with no stage, always does.
  void fail(const std::string& stage, const std::string& sentence);
  /// Stops the run because someone asked for it.
  void cancel();

  /// Fills in how the run ended.
  void record(RunRecord& record) const;

 private:
  void wake_all();

  const bool go_on_;
  std::atomic<bool> stopping_{false};
  std::vector<Doorbell*> doorbells_;
  mutable std::mutex mutex_;
  bool cancelled_ = false;
  std::vector<StageFailure> failures_;
};

}  // namespace stope
