#include <fmt/format.h>
#include <unistd.h>

#include <nlohmann/json.hpp>
#include <thread>

#include "framework/cli/arguments.hpp"
#include "framework/cli/byte_size.hpp"
#include "framework/cli/exit_code.hpp"
#include "framework/cli/interrupt.hpp"
#include "framework/cli/load_pipeline.hpp"
#include "framework/cli/progress_bars.hpp"
#include "framework/executor/run.hpp"
#include "framework/report/run_report.hpp"

namespace stope {
namespace {

std::size_t half_of_ram() {
  return static_cast<std::size_t>(::sysconf(_SC_PHYS_PAGES)) *
         static_cast<std::size_t>(::sysconf(_SC_PAGESIZE)) / 2;
}

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

RunProgress without_taps(const RunProgress& progress) {
  RunProgress shown;
  for (const auto& process : progress.processes) {
    if (!RunReport::is_tap(process.name)) shown.processes.push_back(process);
  }
  return shown;
}

void print_end(const Arguments& arguments, const RunRecord& record, const RunReport& report) {
  const double seconds = static_cast<double>(record.wall) * 1e-9;
  if (arguments.json) {
    constexpr const char* kEnds[] = {"done", "failed", "cancelled"};
    nlohmann::ordered_json end;
    end["end"] = kEnds[static_cast<int>(record.end)];
    end["sentence"] = record.sentence;
    end["seconds"] = seconds;
    end["folder"] = report.folder().string();
    end["report"] = report.report_file().string();
    fmt::print("{}\n", end.dump(2));
    return;
  }
  switch (record.end) {
    case RunRecord::End::kDone:
      if (!arguments.quiet) {
        fmt::print("Done in {:.1f} s, at most {} of memory. Look at {}\n", seconds,
                   byte_size_text(record.peak_resident), report.report_file().string());
      }
      break;
    case RunRecord::End::kFailed:
      fmt::print(stderr, "error: {}\n", record.sentence);
      break;
    case RunRecord::End::kCancelled:
      fmt::print(stderr,
                 "Cancelled after {:.1f} s. Outputs of an earlier run were left as they were.\n",
                 seconds);
      break;
  }
}

}  // namespace

int run_command(const Arguments& arguments) {
  const LoadedPipeline loaded = load_pipeline(arguments);
  if (!loaded.plan) return loaded.exit_code;
  const Plan& plan = *loaded.plan;

  RunOptions options;
  options.threads = arguments.threads > 0 ? arguments.threads
                                          : static_cast<int>(std::thread::hardware_concurrency());
  options.memory = arguments.memory > 0 ? arguments.memory : half_of_ram();
  options.seed = arguments.seed;

  RunFacts facts;
  facts.version = STOPE_VERSION;
  facts.command = arguments.command_line;
  facts.threads = options.threads;
  facts.memory = options.memory;
  facts.seed = options.seed;
  facts.warnings = loaded.warnings;

  const std::filesystem::path folder =
      arguments.out.empty() ? std::filesystem::path("out") / arguments.pipeline.stem()
                            : arguments.out;
  const Interrupt interrupt;
  options.stop = &interrupt.flag();
  RunReport report(plan, *loaded.catalogue, facts, folder);
  options.scratch = report.scratch();
  ProgressBars bars(::isatty(STDERR_FILENO) != 0 && !arguments.json,
                    arguments.quiet || arguments.json);
  Narrator narrator(bars, report);
  const RunRecord record = run_plan(
      plan, *loaded.catalogue, report.sinks(), options, narrator,
      [&, told = false](const RunProgress& progress) mutable {
        bars.show(without_taps(progress));
        if (told || !interrupt.flag()) return;
        told = true;
        narrator.log(LogLevel::kWarning, "",
                     "stopping; interrupt once more to end at once and leave its temporary files");
      });
  warn_of_memory(options, record, narrator);
  bars.finish();
  report.finish(record);
  print_end(arguments, record, report);
  return record.end == RunRecord::End::kDone ? kDone : kRunFailed;
}

}  // namespace stope
