#pragma once

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "framework/executor/run_record.hpp"
#include "framework/pipeline/plan.hpp"
#include "framework/plugins/catalogue.hpp"

namespace stope {

/// A reader of a stage's output that belongs to the framework: writes artefacts, draws previews. It
/// runs as a process of its own and sees each item in order; an exception it throws stops the run
/// like a stage's.
struct Sink {
  std::string name;
  PlannedSource source;
  std::function<void(const AnyItem& item)> consume;
  std::function<void()>
      finish;  ///< after the last item of a run that was not stopped; may be empty
};

/// What a run is allowed and told.
struct RunOptions {
  int threads = 0;         ///< oneTBB workers; 0: as many as the machine has
  std::size_t memory = 0;  ///< bytes for the whole process; 0: half of the machine's
  std::uint64_t seed = 0;
  std::size_t channel_capacity = 16;  ///< items, to begin with
  std::filesystem::path
      scratch;  ///< a folder for spilled payloads and temporary folders, removed after
  const std::atomic<bool>* stop = nullptr;  ///< set by Ctrl-C
  /// Whether stages that do not depend on one that failed are still run to their end; else the
  /// first failure stops all. What depends on it is given nothing more and ends.
  bool go_on_after_failure = false;
};

/// What a run tells while it goes on. Called from many threads, one call at a time for each method.
struct RunObserver {
  virtual ~RunObserver() = default;
  virtual void log(LogLevel level, const std::string& stage, const std::string& sentence) = 0;
};

/// A look at a running network, for progress bars.
struct RunProgress {
  struct Process {
    std::string name;
    std::uint64_t items_read = 0, items_written = 0;
    double fraction = -1;  ///< as the stage told; -1: it did not
    bool finished = false;
  };
  std::vector<Process> processes;
};

/// Runs a plan to its end and says how it went. The record is complete also when the run failed or
/// was cancelled; nothing is thrown but std::bad_alloc. `progress`, if given, is called from a
/// thread of its own a few times a second.
RunRecord run_plan(const Plan& plan, const Catalogue& catalogue, const std::vector<Sink>& sinks,
                   const RunOptions& options, RunObserver& observer,
                   const std::function<void(const RunProgress&)>& progress = {});

}  // namespace stope
