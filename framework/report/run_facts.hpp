#pragma once

#include <chrono>
#include <cstdint>
#include <string>
#include <vector>

#include "framework/diagnostics/diagnostic.hpp"

namespace stope {

/// What the report tells of a run that neither its plan nor its record knows.
struct RunFacts {
  std::string version;               ///< of Stope
  std::vector<std::string> command;  ///< the command line, word by word
  int threads = 0;                   ///< oneTBB workers, as resolved
  std::size_t memory = 0;            ///< bytes, as resolved
  std::uint64_t seed = 0;
  std::chrono::system_clock::time_point start = std::chrono::system_clock::now();
  std::vector<Diagnostic> warnings;  ///< what the check said of the pipeline
};

}  // namespace stope
