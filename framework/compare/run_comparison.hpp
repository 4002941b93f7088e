#pragma once

#include "framework/compare/compare_job.hpp"
#include "framework/compare/comparison.hpp"

namespace stope {

/// Runs an experiment into a folder: for each recording and seed the arms that are left, merged
/// into one graph. comparison.json is written anew after each, so that it tells how far it came
/// whenever the process ends. A folder that holds the same experiment is gone on with: what its
/// cells hold is not computed again if nothing that it depends on has changed. The comparison is
/// not complete if it was cancelled. Throws Error if the folder is in use, holds another
/// experiment, or cannot be written, WrongExperiment if the first results show that a metric's
/// figure is never given.
Comparison run_comparison(const CompareJob& job);

}  // namespace stope
