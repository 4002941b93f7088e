#pragma once

#include <functional>

#include "framework/cache/cached_run.hpp"
#include "framework/report/run_report.hpp"

namespace stope {

/// Runs a plan with a store and lets the report read along. Of stages that do not run the report
/// gets the pictures and digests that an earlier run noted. Afterwards the report knows what became
/// of each stage; finish() it.
RunRecord run_and_report(CachedRun& run, const Plan& plan, RunReport& report,
                         const RunOptions& options,
                         const std::function<void(const RunProgress&)>& progress = {});

/// What became of a stage with this key, as run.json tells it.
StageReuse stage_reuse(const StageKey& key, Fate fate);

}  // namespace stope
