#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include "framework/diagnostics/diagnostic.hpp"

namespace stope {

/// What became of a stage in a run that may take outputs from a store.
struct StageReuse {
  enum class From : int {
    kRun,       ///< it ran
    kReopened,  ///< a source that loads from its own files as they are touched, once more
    kStore,     ///< its outputs were computed by an earlier run
    kNotNeeded  ///< nobody asked for its outputs
  } from = From::kRun;
  std::string key;  ///< 32 hexadecimal digits
  /// What the key is made of: names and values.
  std::vector<std::pair<std::string, std::string>> parts;
  bool only_this_run = false;  ///< it may give other bytes each time
};

/// What the report tells of a run that neither its plan nor its record knows.
struct RunFacts {
  std::string version;                 ///< of Stope
  std::vector<std::string> command;    ///< the command line, word by word
  std::vector<std::string> overrides;  ///< of the pipeline, as `--set` has them
  std::filesystem::path working_folder = std::filesystem::current_path();
  int threads = 0;         ///< oneTBB workers, as resolved
  std::size_t memory = 0;  ///< bytes, as resolved
  std::uint64_t seed = 0;
  std::chrono::system_clock::time_point start = std::chrono::system_clock::now();
  std::vector<Diagnostic> warnings;  ///< what the check said of the pipeline
};

}  // namespace stope
