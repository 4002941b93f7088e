#pragma once

#include <string>

#include "framework/report/report_data.hpp"

namespace stope::report {

/// The pictures of a run: road graphs and paths across the page, the last made first; then the
/// others in the order of the pipeline. Empty if there is none.
std::string gallery_html(const ReportData& data);

/// The figures of all measures as a table. Empty if there is none.
std::string measures_html(const ReportData& data);

}  // namespace stope::report
