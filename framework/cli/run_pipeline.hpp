#pragma once

#include <atomic>
#include <filesystem>
#include <vector>

#include "framework/cache/cached_run.hpp"
#include "framework/cli/arguments.hpp"
#include "framework/cli/load_pipeline.hpp"

namespace stope {

/// How a pipeline's run went and what it left.
struct PipelineRun {
  RunRecord record;
  std::vector<StageKey> keys;  ///< by stage of the plan
  Reuse reuse;
  std::filesystem::path folder, report_file;
};

/// Runs a loaded pipeline into a run directory, with threads, memory and seed of the arguments,
/// showing its progress on the terminal. Throws Error if the directory cannot be written to,
/// Cancelled if `stop` is set before the run begins.
PipelineRun run_pipeline(const LoadedPipeline& pipeline, const Arguments& arguments,
                         const CacheUse& use, const std::filesystem::path& folder,
                         const std::atomic<bool>& stop);

}  // namespace stope
