#include "framework/executor/monitor.hpp"

#include <chrono>
#include <utility>

namespace stope {

Monitor::Monitor(std::function<void()> look) : look_(std::move(look)) {
  thread_ = std::thread([this] {
    std::unique_lock lock(mutex_);
    while (!end_) {
      lock.unlock();
      look_();
      lock.lock();
      wake_.wait_for(lock, std::chrono::milliseconds(20), [this] { return end_; });
    }
  });
}

Monitor::~Monitor() {
  {
    const std::lock_guard lock(mutex_);
    end_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

}  // namespace stope
