#pragma once

#include "framework/compare/compare_job.hpp"
#include "framework/compare/comparison.hpp"

namespace stope {

/// As `--set` takes them.
std::vector<std::string> texts_of(const std::vector<Override>& overrides);

/// A comparison of which nothing was run yet: its lists, and a table whose cells are pending, or
/// excluded where an arm lacks a recording.
Comparison new_comparison(const CompareJob& job);

}  // namespace stope
