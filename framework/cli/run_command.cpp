#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <utility>

#include "framework/cache/earlier_run.hpp"
#include "framework/cache/store_folder.hpp"
#include "framework/cli/arguments.hpp"
#include "framework/cli/byte_size.hpp"
#include "framework/cli/cache_use.hpp"
#include "framework/cli/exit_code.hpp"
#include "framework/cli/interrupt.hpp"
#include "framework/cli/run_pipeline.hpp"

namespace stope {
namespace {

std::optional<EarlierRun> earlier_run(const std::filesystem::path& folder) {
  try {
    return read_earlier_run(folder / "run.json");
  } catch (const Error&) {
    return std::nullopt;
  }
}

using Reasons = std::vector<std::pair<std::string, std::string>>;

/// By stage that ran: its name, and why it did.
Reasons reasons_of(const Plan& plan, const PipelineRun& run,
                   const std::optional<EarlierRun>& earlier, bool take) {
  Reasons reasons;
  for (std::size_t i = 0; i < run.reuse.fates.size(); ++i) {
    const std::string& name = plan.stages[i].name;
    if (run.reuse.fates[i] == Fate::kRuns)
      reasons.emplace_back(name,
                           why_it_runs(name, run.keys[i], earlier ? &*earlier : nullptr, take));
  }
  return reasons;
}

void print_json(const PipelineRun& run, const Reasons* reasons) {
  constexpr const char* kEnds[] = {"done", "failed", "cancelled"};
  nlohmann::ordered_json end;
  end["end"] = kEnds[static_cast<int>(run.record.end)];
  end["sentence"] = run.record.sentence;
  end["seconds"] = static_cast<double>(run.record.wall) * 1e-9;
  end["folder"] = run.folder.string();
  end["report"] = run.report_file.string();
  end["stages"] = {{"run", run.reuse.count(Fate::kRuns)},
                   {"reopened", run.reuse.count(Fate::kReopened)},
                   {"store", run.reuse.count(Fate::kStored)},
                   {"not_needed", run.reuse.count(Fate::kNotNeeded)}};
  if (reasons) {
    end["why"] = nlohmann::ordered_json::object();
    for (const auto& [stage, reason] : *reasons) end["why"][stage] = reason;
  }
  fmt::print("{}\n", end.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace));
}

void print_text(const PipelineRun& run, bool quiet) {
  const double seconds = static_cast<double>(run.record.wall) * 1e-9;
  switch (run.record.end) {
    case RunRecord::End::kDone:
      if (!quiet) {
        fmt::print("Done in {:.1f} s, at most {} of memory. Look at {}\n", seconds,
                   byte_size_text(run.record.peak_resident), run.report_file.string());
      }
      break;
    case RunRecord::End::kFailed:
      fmt::print(stderr, "error: {}\n", run.record.sentence);
      break;
    case RunRecord::End::kCancelled:
      fmt::print(stderr,
                 "Cancelled after {:.1f} s. Outputs of an earlier run were left as they were.\n",
                 seconds);
      break;
  }
}

void refuse_store(const std::filesystem::path& folder) {
  if (is_store(folder))
    throw Error(fmt::format(
        "{} is a store of results, in which a run would leave files that do not belong there. "
        "Choose another folder with --out.",
        folder.string()));
}

/// The runs of a comparison are its own: it would compute anew what another run wrote over.
void refuse_runs_of_comparisons(const std::filesystem::path& folder) {
  const std::filesystem::path whole = std::filesystem::absolute(folder).lexically_normal();
  for (std::filesystem::path above = whole.parent_path(); above != above.root_path();
       above = above.parent_path()) {
    std::error_code ignored;
    if (std::filesystem::exists(above / "comparison.json", ignored))
      throw Error(
          fmt::format("{} lies in the folder of a comparison, {}, whose runs are its own. Choose "
                      "another folder "
                      "with --out.",
                      folder.string(), above.string()));
  }
}

}  // namespace

int run_command(const Arguments& arguments) {
  const LoadedPipeline loaded = load_pipeline(arguments);
  if (!loaded.plan) return loaded.exit_code;
  const CacheUse use = cache_use(arguments);
  const std::filesystem::path folder =
      arguments.out.empty() ? std::filesystem::path("out") / arguments.pipeline.stem()
                            : arguments.out;
  refuse_store(folder);
  refuse_runs_of_comparisons(folder);
  const std::optional<EarlierRun> earlier = earlier_run(folder);
  const Interrupt interrupt;
  PipelineRun run;
  try {
    run = run_pipeline(loaded, arguments, use, folder, interrupt.flag());
  } catch (const Cancelled&) {
    fmt::print(stderr, "Cancelled before the first stage ran.\n");
    return kRunFailed;
  }
  const Reasons reasons = reasons_of(*loaded.plan, run, earlier, !use.store.empty());
  if (arguments.json) {
    print_json(run, arguments.why ? &reasons : nullptr);
  } else {
    if (arguments.why)
      for (const auto& [stage, reason] : reasons) fmt::print("{} ran: {}\n", stage, reason);
    print_text(run, arguments.quiet);
  }
  return run.record.end == RunRecord::End::kDone ? kDone : kRunFailed;
}

}  // namespace stope
