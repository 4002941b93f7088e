#pragma once

namespace stope::report {

/// What the comparison page adds to the style sheet of the run's report.
const char* comparison_style();

}  // namespace stope::report
