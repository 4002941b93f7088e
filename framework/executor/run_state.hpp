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
  /// A process to wake when the run stops. Before the run begins.
  void add(Doorbell& doorbell) { doorbells_.push_back(&doorbell); }

  bool stopping() const { return stopping_.load(std::memory_order_acquire); }
  /// Stops the run because of an error. `sentence` names stage, item and time.
  void fail(const std::string& stage, const std::string& sentence);
  /// Stops the run because someone asked for it.
  void cancel();

  RunRecord::End end() const;
  /// Of a failed run.
  std::string failed_stage() const;
  std::string sentence() const;

 private:
  void stop(RunRecord::End end, const std::string& stage, const std::string& sentence);

  std::atomic<bool> stopping_{false};
  std::vector<Doorbell*> doorbells_;
  mutable std::mutex mutex_;
  RunRecord::End end_ = RunRecord::End::kDone;
  std::string failed_stage_, sentence_;
};

}  // namespace stope
