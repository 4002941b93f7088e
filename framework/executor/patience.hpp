#pragma once

#include <algorithm>
#include <thread>

namespace stope {

/// How long a process looks for what it waits for before it sleeps. Waking a sleeper costs
/// microseconds, several times what an item costs otherwise; looking on costs a core that another
/// process may need. So it looks longer after looking has helped and hardly at all after it has
/// not. Of one thread.
class Patience {
 public:
  /// Whether `ready` became true while looking.
  template <class Ready>
  bool wait_for(const Ready& ready) {
    for (int look = 0; look < looks_; ++look) {
      if (ready()) {
        looks_ = std::min(looks_ * 2, kMostLooks);
        return true;
      }
      // Lets the awaited process run, if it is this core that it waits for.
      std::this_thread::yield();
    }
    looks_ = std::max(looks_ / 2, kLeastLooks);
    return false;
  }

 private:
  static constexpr int kLeastLooks = 2;
  static constexpr int kMostLooks = 64;
  int looks_ = kMostLooks;
};

}  // namespace stope
