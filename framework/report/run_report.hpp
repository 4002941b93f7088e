#pragma once

#include <filesystem>
#include <memory>
#include <string_view>
#include <vector>

#include "framework/executor/run.hpp"
#include "framework/report/run_facts.hpp"

namespace stope {

/// The folder a run leaves behind: outputs/, run.json, log.txt, trace.json and report.html.
///
///     RunReport report(plan, catalogue, facts, "out");      // throws Error: say it and stop
///     options.scratch = report.scratch();
///     RunRecord record = run_plan(plan, catalogue, report.sinks(), options, observer, progress);
///     report.finish(record);                                // throws Error: the run failed
///
/// and the observer passes what it is told on to log(). Until finish() nothing that stood in the
/// folder changes; a run that ended well then has its files put in place, one rename each; any
/// other run leaves the earlier outputs alone and replaces only the four files that say how it
/// went. Without finish() nothing of the run remains.
class RunReport {
 public:
  /// Makes the folder, locks it and checks the outputs' names. `plan` and `catalogue` must live
  /// as long as this. Throws Error with a sentence for the operator.
  RunReport(const Plan& plan, const Catalogue& catalogue, RunFacts facts,
            const std::filesystem::path& folder);
  ~RunReport();
  RunReport(const RunReport&) = delete;

  /// The processes that write outputs and draw previews. They refer to this object.
  std::vector<Sink> sinks();
  /// For RunOptions::scratch; removed with this object.
  std::filesystem::path scratch() const;
  /// Adds a line to log.txt. Any thread may call it. An empty stage stands for the run.
  void log(LogLevel level, std::string_view stage, std::string_view sentence);
  /// Writes everything. Throws Error if the disk is full or the folder has become unwritable; what
  /// an earlier run left is then still there.
  void finish(const RunRecord& record);

  /// Where to look.
  std::filesystem::path folder() const;
  std::filesystem::path report_file() const;
  /// Whether a process of the record is one of the report's own taps, of no interest to a person.
  static bool is_tap(std::string_view process_name);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace stope
