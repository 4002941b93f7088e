#pragma once

#include <cstdint>
#include <string>

namespace stope::report {

/// The machine a run was made on. What cannot be found out is empty or 0.
struct Machine {
  std::string host;
  std::string processor;     ///< model name
  int cores = 0;             ///< that this process may use
  std::uint64_t memory = 0;  ///< bytes
  std::string system;        ///< distribution and kernel
};

Machine this_machine();

}  // namespace stope::report
