#pragma once

#include <string>

#include "framework/report/report_data.hpp"

namespace stope::report {

/// How each process spent the run: a strip along the run's time, its sums and its items; and how
/// the channels between them were used.
std::string times_html(const ReportData& data);
std::string channels_html(const ReportData& data);

}  // namespace stope::report
