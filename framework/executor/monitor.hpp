#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

namespace stope {

/// A thread that looks at something every 20 ms until it is destroyed. A stop flag set by a signal
/// handler can wake nobody, so someone has to look.
class Monitor {
 public:
  explicit Monitor(std::function<void()> look);
  ~Monitor();
  Monitor(const Monitor&) = delete;
  Monitor& operator=(const Monitor&) = delete;

 private:
  std::function<void()> look_;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool end_ = false;
  std::thread thread_;
};

}  // namespace stope
