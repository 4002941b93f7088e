#pragma once

#include <atomic>

namespace stope {

/// Turns Ctrl-C, a polite kill and a closed terminal into a flag that a run watches. A second
/// Ctrl-C ends the process at once, for the case that a stage does not listen. Only one may exist
/// at a time.
class Interrupt {
 public:
  Interrupt();
  ~Interrupt();
  Interrupt(const Interrupt&) = delete;
  Interrupt& operator=(const Interrupt&) = delete;
  const std::atomic<bool>& flag() const;
};

}  // namespace stope
