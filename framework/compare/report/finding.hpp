#pragma once

#include <string>

#include "framework/compare/verdicts.hpp"

namespace stope::report {

/// What was found of an arm, in a sentence or two: `voronoi is better than watershed in apls by
/// 0.34 [0.28, 0.41] on 10 recordings, and it matters; no difference shown in coverage.`
std::string finding_text(const Comparison& comparison, const ArmVerdicts& verdicts);

/// `0.34 [0.28, 0.41]`: two figures of the interval's width; above 0 the arm is better. `0.34 [–]`
/// of so few recordings that no interval can be believed.
std::string difference_text(const ComparedMeasure& measure);

/// A number to as many places as an interval of that width is worth.
std::string to_width(double value, double width);

/// `0.004`, `< 0.001`.
std::string chance_text(double chance);

}  // namespace stope::report
