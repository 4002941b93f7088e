#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string_view>
#include <vector>

#include "framework/executor/run.hpp"
#include "framework/report/run_facts.hpp"
#include "framework/report/tap_result.hpp"
#include "framework/report/written_output.hpp"

namespace stope {

/// How processes that belong to nobody's pipeline are called.
inline constexpr std::string_view kTapPrefix = "report: ", kStorePrefix = "store: ";

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

  /// What it cannot do without: the outputs' artefacts, and measures or drawings that exist to be
  /// reported.
  std::vector<PlannedSource> needed() const;
  /// The outputs it also reads along at, for pictures and digests, if they are to be had.
  std::vector<PlannedSource> welcome() const;
  /// The processes that write outputs and draw previews: of what is needed, and of the rest what
  /// `reads` agrees to. They refer to this object. Called again it begins anew: what was written
  /// and drawn before is forgotten.
  std::vector<Sink> sinks(const std::function<bool(const PlannedSource&)>& reads = {});
  /// What has been seen at an output, by a sink that has come to its end.
  report::TapResult seen(const PlannedSource& source) const;
  /// Tells what an earlier run has seen at a welcome output that is not read in this one.
  void know(report::TapResult result);
  /// Tells what became of each stage of the plan.
  void set_reuse(std::vector<StageReuse> reuse);
  /// For RunOptions::scratch; removed with this object.
  std::filesystem::path scratch() const;
  /// Adds a line to log.txt. Any thread may call it. An empty stage stands for the run.
  void log(LogLevel level, std::string_view stage, std::string_view sentence);
  /// Writes everything. Throws Error if the disk is full or the folder has become unwritable; what
  /// an earlier run left is then still there.
  void finish(const RunRecord& record);

  /// What is in place now, in the order of the pipeline's outputs; after finish().
  const std::vector<report::WrittenFile>& outputs() const;

  /// Where to look.
  std::filesystem::path folder() const;
  std::filesystem::path report_file() const;
  /// Whether a process of the record is the framework's own, a tap of the report or a writer of the
  /// store, of no interest to a person.
  static bool is_tap(std::string_view process_name);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace stope
