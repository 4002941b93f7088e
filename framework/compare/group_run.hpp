#pragma once

#include <cstdint>
#include <functional>

#include "framework/compare/compare_job.hpp"
#include "framework/compare/comparison.hpp"
#include "framework/compare/metric_check.hpp"

namespace stope {

/// Runs what is pending of one recording with one seed as one graph, so that what arms have in
/// common runs once, and fills the cells. Where a stage fails, the arms it belongs to have failed;
/// the others go on to their end in the same run. False if it was cancelled: cells may then be
/// pending still. Throws Error if results cannot be written, WrongExperiment if they show that a
/// metric is hopeless.
bool run_group(const CompareJob& job, std::size_t recording, std::size_t seed, MetricCheck& metrics,
               Comparison& comparison);

}  // namespace stope
