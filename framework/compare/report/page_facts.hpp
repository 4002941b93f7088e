#pragma once

#include <string>
#include <vector>

#include "framework/compare/verdicts.hpp"

namespace stope::report {

/// Name, what was found, and how much was run.
std::string comparison_header_html(const Comparison& comparison,
                                   const std::vector<ArmVerdicts>& verdicts);

/// What was left out of the statistics and why. Empty if nothing was.
std::string exclusions_html(const Comparison& comparison);

/// How the comparison was made: files, arms with their stages, recordings, seeds.
std::string comparison_provenance_html(const Comparison& comparison);

}  // namespace stope::report
