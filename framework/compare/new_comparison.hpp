#pragma once

#include "framework/compare/compare_job.hpp"
#include "framework/compare/comparison.hpp"

namespace stope {

/// A comparison of which nothing was run yet: its lists, and a table whose cells are pending, or
/// excluded where an arm lacks a recording.
Comparison new_comparison(const CompareJob& job);

}  // namespace stope
