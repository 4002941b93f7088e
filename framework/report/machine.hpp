#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace stope::report {

/// The machine a run was made on. What cannot be found out is empty or 0.
struct Machine {
  std::string host;
  std::string processor;     ///< model name
  int cores = 0;             ///< that this process may use
  std::uint64_t memory = 0;  ///< bytes
  std::string system;        ///< distribution and kernel
  /// Instruction sets that libraries choose their code by, which may round differently.
  std::vector<std::string> features;
  std::string libraries;  ///< the C library, whose functions compute sines and logarithms
};

Machine this_machine();

}  // namespace stope::report
