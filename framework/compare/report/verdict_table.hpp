#pragma once

#include <string>
#include <vector>

#include "framework/compare/verdicts.hpp"

namespace stope::report {

/// Every arm by every metric: means, difference with its interval, chances, verdict.
std::string verdict_table_html(const Comparison& comparison,
                               const std::vector<ArmVerdicts>& verdicts);

}  // namespace stope::report
