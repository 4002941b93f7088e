#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "framework/executor/run_record.hpp"

namespace stope::report {

/// The activities in the order they are drawn, with their style class.
inline constexpr std::array<std::string_view, 4> kActivityStyles{"run", "io", "wait-in",
                                                                 "wait-out"};

/// A process's times in the same order, ns.
inline std::array<std::int64_t, 4> activity_times(const ProcessRecord& process) {
  return {process.run, process.io, process.wait_in, process.wait_out};
}

/// The place of an activity in that order.
inline std::size_t activity_place(Activity activity) {
  switch (activity) {
    case Activity::kRun:
      return 0;
    case Activity::kIo:
      return 1;
    case Activity::kWaitIn:
      return 2;
    case Activity::kWaitOut:
      return 3;
  }
  return 0;
}

/// The record of the process of this name, or null.
inline const ProcessRecord* process_named(const RunRecord& record, std::string_view name) {
  for (const ProcessRecord& process : record.processes) {
    if (process.name == name) return &process;
  }
  return nullptr;
}

}  // namespace stope::report
