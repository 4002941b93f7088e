#pragma once

#include <atomic>
#include <filesystem>
#include <string>
#include <vector>

#include "framework/cache/cached_run.hpp"
#include "framework/compare/experiment/experiment_plan.hpp"

namespace stope {

/// What a comparison is allowed and told.
struct CompareOptions {
  std::filesystem::path folder;  ///< what it leaves behind
  int threads = 0;               ///< oneTBB workers
  std::size_t memory = 0;        ///< bytes for the whole process
  CacheUse cache;
  bool time_again = false;  ///< take timings anew that were taken before
  const std::atomic<bool>* stop = nullptr;
  std::string version;               ///< of Stope
  std::vector<std::string> command;  ///< the command line, for the record
};

/// Where a comparison's runs put what they spill, below its folder.
inline std::filesystem::path scratch_of(const std::filesystem::path& folder) {
  return folder / ".scratch.stope-part";
}

/// An experiment that is being run. What is referred to must live as long as this.
struct CompareJob {
  const Experiment& experiment;
  const ExperimentPlan& plan;
  const Catalogue& catalogue;
  const CompareOptions& options;
  RunObserver& observer;

  bool stopping() const { return options.stop && options.stop->load(); }
};

}  // namespace stope
