#pragma once

namespace stope::report {

/// The style sheet of report.html, for light and dark.
const char* page_style();

}  // namespace stope::report
