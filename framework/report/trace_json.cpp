#include "framework/report/trace_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>

namespace stope::report {
namespace {

const char* activity_name(Activity activity) {
  switch (activity) {
    case Activity::kRun:
      return "run";
    case Activity::kWaitIn:
      return "wait-in";
    case Activity::kWaitOut:
      return "wait-out";
    case Activity::kIo:
      return "io";
  }
  return "";
}

std::string json_text(std::string_view text) {
  return nlohmann::json(text).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

double microseconds(std::int64_t nanoseconds) { return static_cast<double>(nanoseconds) * 1e-3; }

std::string metadata(const char* what, std::size_t thread, std::string_view arguments) {
  return fmt::format(R"({{"ph":"M","pid":1,"tid":{},"name":"{}","args":{{{}}}}})", thread, what,
                     arguments);
}

}  // namespace

void write_trace(const RunRecord& record, std::string_view pipeline,
                 const std::function<void(std::string_view)>& write) {
  write("{\"displayTimeUnit\":\"ms\",\"traceEvents\":[\n");
  write(metadata("process_name", 0,
                 fmt::format("\"name\":{}", json_text(fmt::format("stope: {}", pipeline)))));
  for (std::size_t i = 0; i < record.processes.size(); ++i) {
    const ProcessRecord& process = record.processes[i];
    const std::size_t thread = i + 1;
    write(fmt::format(",\n{}", metadata("thread_name", thread,
                                        fmt::format("\"name\":{}", json_text(process.name)))));
    write(fmt::format(
        ",\n{}", metadata("thread_sort_index", thread, fmt::format("\"sort_index\":{}", thread))));
    std::int64_t cursor = process.begin;
    for (const Span& span : process.spans) {
      const bool aggregated = span.count > 1;
      const std::int64_t begin = aggregated ? std::max(cursor, span.begin) : span.begin;
      const std::int64_t length = aggregated ? span.busy : span.end - span.begin;
      const char* name = activity_name(span.activity);
      write(fmt::format(
          ",\n{{\"ph\":\"X\",\"pid\":1,\"tid\":{},\"name\":\"{}{}\",\"cat\":\"{}\",\"ts\":{:.3f},"
          "\"dur\":{:.3f}",
          thread, name, aggregated ? " (aggregated)" : "", name, microseconds(begin),
          microseconds(length)));
      if (aggregated)
        write(fmt::format(",\"args\":{{\"aggregated\":true,\"count\":{}}}", span.count));
      write("}");
      cursor = begin + length;
    }
  }
  write("\n]}\n");
}

}  // namespace stope::report
