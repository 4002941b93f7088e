#pragma once

#include <functional>
#include <string_view>

#include "framework/executor/run_record.hpp"

namespace stope::report {

/// Writes a run as Chrome trace events (JSON object format), which Perfetto and chrome://tracing
/// open: one thread a process of the network, one complete event a span, times in microseconds.
/// Spans that stand for many (`count` > 1) are named `… (aggregated)`: they are as long as the time
/// they sum, laid one after another from where the stretch they cover begins.
void write_trace(const RunRecord& record, std::string_view pipeline,
                 const std::function<void(std::string_view)>& write);

}  // namespace stope::report
