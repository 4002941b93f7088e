#include <fmt/format.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "framework/cli/arguments.hpp"
#include "framework/cli/cache_use.hpp"
#include "framework/cli/comparison_text.hpp"
#include "framework/cli/exit_code.hpp"
#include "framework/cli/interrupt.hpp"
#include "framework/cli/load_experiment.hpp"
#include "framework/cli/load_pipeline.hpp"
#include "framework/cli/progress_bars.hpp"
#include "framework/cli/resources.hpp"
#include "framework/compare/metric_check.hpp"
#include "framework/compare/report/comparison_page.hpp"
#include "framework/compare/run_comparison.hpp"

namespace stope {
namespace {

bool any_failed(const Comparison& comparison) {
  for (const ComparedCell& cell : comparison.cells)
    if (cell.status == CellStatus::kFailed) return true;
  return false;
}

void print_end(const Arguments& arguments, const Comparison& comparison) {
  if (arguments.json) {
    fmt::print("{}\n", comparison_end_json(comparison).dump(2));
    return;
  }
  if (!arguments.quiet) fmt::print("{}", comparison_text(comparison));
  if (!comparison.complete)
    fmt::print(stderr, "Cancelled. The same command goes on where it stopped.\n");
}

}  // namespace

int compare_command(const Arguments& arguments) {
  const LoadedExperiment loaded = load_experiment(arguments);
  if (!loaded.plan) return loaded.exit_code;

  const Interrupt interrupt;
  CompareOptions options;
  options.folder = std::filesystem::absolute(arguments.out.empty() ? std::filesystem::path("out") /
                                                                         arguments.pipeline.stem()
                                                                   : arguments.out);
  options.threads = threads_of(arguments);
  options.memory = memory_of(arguments);
  options.cache = cache_use(arguments);
  options.time_again = arguments.time_again;
  options.stop = &interrupt.flag();
  options.version = STOPE_VERSION;
  options.command = arguments.command_line;
  ProgressBars narrator(false, arguments.quiet || arguments.json);
  Comparison comparison;
  try {
    comparison =
        run_comparison({*loaded.experiment, *loaded.plan, *loaded.catalogue, options, narrator});
  } catch (const WrongExperiment& error) {
    narrator.finish();
    print_diagnostics(error.diagnostics(), arguments.json);
    return kWrongArguments;
  }
  narrator.finish();
  report::write_comparison_report(comparison);
  print_end(arguments, comparison);
  return comparison.complete && !any_failed(comparison) ? kDone : kRunFailed;
}

}  // namespace stope
