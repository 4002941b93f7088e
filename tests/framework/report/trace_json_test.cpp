#include "framework/report/trace_json.hpp"

#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>
#include <string>

namespace stope::report {
namespace {

nlohmann::json trace_of(const RunRecord& record) {
  std::string text;
  write_trace(record, "a \"quoted\" name", [&text](std::string_view part) { text += part; });
  return nlohmann::json::parse(text);
}

RunRecord two_processes() {
  RunRecord record;
  ProcessRecord plain;
  plain.name = "scans";
  plain.begin = 1'000'000;
  plain.end = 5'000'000;
  plain.spans = {{Activity::kIo, 1'000'000, 2'500'000, 1'500'000, 1},
                 {Activity::kRun, 2'500'000, 3'000'001, 500'001, 1},
                 {Activity::kWaitOut, 3'000'001, 5'000'000, 1'999'999, 1}};
  ProcessRecord busy;
  busy.name = "</script>";
  busy.begin = 0;
  busy.end = 10'000'000;
  busy.spans = {{Activity::kRun, 0, 10'000'000, 7'000'000, 4000},
                {Activity::kWaitIn, 0, 10'000'000, 2'950'000, 4000}};
  record.processes = {plain, busy};
  return record;
}

TEST(TraceJson, HasThePartsThatChromeAndPerfettoAskFor) {
  const auto trace = trace_of(two_processes());
  ASSERT_TRUE(trace["traceEvents"].is_array());
  std::map<int, std::string> threads;
  for (const auto& event : trace["traceEvents"]) {
    ASSERT_TRUE(event.contains("ph") && event.contains("pid") && event.contains("tid"));
    if (event["name"] == "thread_name") threads[event["tid"]] = event["args"]["name"];
    if (event["ph"] == "X") {
      EXPECT_TRUE(event["ts"].is_number() && event["dur"].is_number());
    }
  }
  EXPECT_EQ(threads, (std::map<int, std::string>{{1, "scans"}, {2, "</script>"}}));
  EXPECT_EQ(trace["traceEvents"][0]["args"]["name"], "stope: a \"quoted\" name");
}

TEST(TraceJson, SpansSumToTheLifeOfEachProcessAndDoNotOverlap) {
  const RunRecord record = two_processes();
  std::map<int, double> sums, ends;
  const auto trace = trace_of(record);
  for (const auto& event : trace["traceEvents"]) {
    if (event["ph"] != "X") continue;
    const int thread = event["tid"];
    const double begin = event["ts"], length = event["dur"];
    EXPECT_GE(begin, ends[thread] - 1e-9);
    sums[thread] += length;
    ends[thread] = begin + length;
  }
  for (std::size_t i = 0; i < record.processes.size(); ++i) {
    const ProcessRecord& process = record.processes[i];
    const double life = static_cast<double>(process.end - process.begin) * 1e-3;
    EXPECT_GE(sums[static_cast<int>(i) + 1], 0.98 * life) << process.name;
    EXPECT_LE(sums[static_cast<int>(i) + 1], life + 1e-9) << process.name;
  }
}

TEST(TraceJson, FlagsSpansThatStandForMany) {
  const auto trace = trace_of(two_processes());
  for (const auto& event : trace["traceEvents"]) {
    if (event["ph"] != "X") continue;
    const bool aggregated = event["tid"] == 2;
    EXPECT_EQ(event["name"].get<std::string>().find("(aggregated)") != std::string::npos,
              aggregated);
    if (aggregated) {
      EXPECT_EQ(event["args"]["count"], 4000);
    }
  }
}

}  // namespace
}  // namespace stope::report
