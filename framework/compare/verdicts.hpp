#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "framework/compare/comparison.hpp"

namespace stope {

/// What a comparison says of one arm beside the baseline.
struct ArmVerdicts {
  std::size_t arm = 0;
  std::vector<ComparedMeasure> measures;  ///< by metric, as Comparison::metrics
  /// An earlier arm that left the same files and figures in every cell, bit for bit. Its verdicts
  /// are this one's.
  std::optional<std::size_t> twin;
};

/// The verdicts of all arms but the baseline. One family of tests: the chance that any of them is
/// a false alarm is below 0.05, for who has several arms looks at the one that stands out (Demsar,
/// Statistical Comparisons of Classifiers over Multiple Data Sets, 2006, sec. 3.2). An arm that is
/// a copy of an earlier one, by its keys or by all that it left, has its verdicts and is not
/// counted again: looking twice at the same figures is no second chance. Recordings that an arm or
/// the baseline lacks are in `excluded`. Deterministic.
std::vector<ArmVerdicts> verdicts_of(const Comparison& comparison);

}  // namespace stope
