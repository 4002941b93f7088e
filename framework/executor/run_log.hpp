#pragma once

#include <mutex>
#include <string>

#include "framework/executor/run.hpp"

namespace stope {

/// Passes log sentences of all threads to the observer, one at a time.
class RunLog {
 public:
  explicit RunLog(RunObserver& observer) : observer_(observer) {}
  void write(LogLevel level, const std::string& stage, const std::string& sentence) {
    const std::lock_guard lock(mutex_);
    observer_.log(level, stage, sentence);
  }

 private:
  std::mutex mutex_;
  RunObserver& observer_;
};

}  // namespace stope
