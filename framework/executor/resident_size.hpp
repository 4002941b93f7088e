#pragma once

#include <cstddef>

namespace stope {

/// What this process takes of the machine's memory, as the kernel counts it. A measure costs about
/// a microsecond.
class ResidentSize {
 public:
  ResidentSize();
  ~ResidentSize();
  ResidentSize(const ResidentSize&) = delete;
  ResidentSize& operator=(const ResidentSize&) = delete;

  /// Bytes now; 0 if the kernel does not tell.
  std::size_t measure() const;
  /// The most there ever was (VmHWM), bytes; 0 if the kernel does not tell.
  static std::size_t peak();
  /// The machine's memory, bytes.
  static std::size_t of_machine();

 private:
  int statm_;
  std::size_t page_;
};

}  // namespace stope
