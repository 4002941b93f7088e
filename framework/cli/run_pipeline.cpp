#include "framework/cli/run_pipeline.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include "framework/cache/reported_run.hpp"
#include "framework/cli/byte_size.hpp"
#include "framework/cli/progress_bars.hpp"
#include "framework/cli/resources.hpp"
#include "framework/report/run_report.hpp"

namespace stope {
namespace {

// Sends what a run says both to the terminal and to the run's log.
class Narrator final : public RunObserver {
 public:
  Narrator(ProgressBars& bars, RunReport& report) : bars_(bars), report_(report) {}
  void log(LogLevel level, const std::string& stage, const std::string& sentence) override {
    report_.log(level, stage, sentence);
    bars_.log(level, stage, sentence);
  }

 private:
  ProgressBars& bars_;
  RunReport& report_;
};

// Stages' own working memory is theirs; the budget can only make payloads give way to it.
void warn_of_memory(const RunOptions& options, const RunRecord& record, Narrator& narrator) {
  if (static_cast<double>(record.peak_resident) <= 1.1 * static_cast<double>(options.memory))
    return;
  narrator.log(
      LogLevel::kWarning, "",
      fmt::format(
          "{} of memory were used though --memory allows {}: the stages alone needed more; allow "
          "more or give them smaller maps",
          byte_size_text(record.peak_resident), byte_size_text(options.memory)));
}

void warn_of_store(const std::string& complaint, Narrator& narrator) {
  if (complaint.empty()) return;
  narrator.log(LogLevel::kWarning, "",
               fmt::format("not all could be taken from the store or kept in it: {}. The results "
                           "are complete; some will be computed again next time",
                           complaint));
}

// Stages come first, in the order of the plan; those that do not run have nothing to show.
RunProgress what_runs(const RunProgress& progress, const Reuse& reuse) {
  RunProgress shown;
  for (std::size_t i = 0; i < progress.processes.size(); ++i) {
    const bool idle = i < reuse.fates.size() && !is_made(reuse.fates[i]);
    if (!idle && !RunReport::is_tap(progress.processes[i].name))
      shown.processes.push_back(progress.processes[i]);
  }
  return shown;
}

}  // namespace

PipelineRun run_pipeline(const LoadedPipeline& pipeline, const Arguments& arguments,
                         const CacheUse& use, const std::filesystem::path& folder,
                         const std::atomic<bool>& stop) {
  const Plan& plan = *pipeline.plan;
  RunOptions options;
  options.threads = threads_of(arguments);
  options.memory = memory_of(arguments);
  options.seed = arguments.seed;
  options.stop = &stop;

  RunFacts facts;
  facts.version = STOPE_VERSION;
  facts.command = arguments.command_line;
  facts.overrides = arguments.overrides;
  facts.threads = options.threads;
  facts.memory = options.memory;
  facts.seed = options.seed;
  facts.warnings = pipeline.warnings;

  RunReport report(plan, *pipeline.catalogue, facts, folder);
  options.scratch = report.scratch();
  ProgressBars bars(::isatty(STDERR_FILENO) != 0 && !arguments.json,
                    arguments.quiet || arguments.json);
  Narrator narrator(bars, report);
  CachedRun run(plan, *pipeline.catalogue, options.seed, use, narrator, &stop);
  PipelineRun result;
  result.record = run_and_report(
      run, plan, report, options, [&, told = false](const RunProgress& progress) mutable {
        bars.show(what_runs(progress, run.reuse()));
        if (told || !stop) return;
        told = true;
        narrator.log(LogLevel::kWarning, "",
                     "stopping; interrupt once more to end at once and leave its temporary files");
      });
  warn_of_memory(options, result.record, narrator);
  warn_of_store(run.complaint(), narrator);
  bars.finish();
  report.finish(result.record);
  result.keys = run.keys();
  result.reuse = run.reuse();
  result.folder = report.folder();
  result.report_file = report.report_file();
  return result;
}

}  // namespace stope
