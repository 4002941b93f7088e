#pragma once

#include <string>

#include "framework/report/report_data.hpp"

namespace stope::report {

/// The files the run left, with links, sizes and checksums.
std::string outputs_html(const ReportData& data);

/// A relative path as an address: what is not plain is percent-encoded.
std::string link_text(const std::string& path);

}  // namespace stope::report
