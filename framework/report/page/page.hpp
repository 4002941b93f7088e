#pragma once

#include <string>

#include "framework/report/report_data.hpp"

namespace stope::report {

/// report.html: one file that opens from disk, without network or scripts.
std::string report_page(const ReportData& data);

}  // namespace stope::report
