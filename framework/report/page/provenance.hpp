#pragma once

#include <string>

#include "framework/report/report_data.hpp"

namespace stope::report {

/// What was run: versions, machine, files, and every stage with its plugin and parameters.
std::string provenance_html(const ReportData& data);

/// Warnings, and the log's last lines.
std::string log_html(const ReportData& data);

}  // namespace stope::report
