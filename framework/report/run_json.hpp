#pragma once

#include <string>

#include "framework/report/report_data.hpp"

namespace stope::report {

/// run.json: what ran, on what, how it went and what it left. docs/run_directory.md describes each
/// field. Keys stand in a fixed order.
std::string run_json(const ReportData& data);

/// `done`, `failed` or `cancelled`.
const char* end_name(RunRecord::End end);

/// A point in time as `2026-11-22T18:12:31.250Z`.
std::string utc_text(std::chrono::system_clock::time_point time);

}  // namespace stope::report
