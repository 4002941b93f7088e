#include "framework/compare/timing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "framework/cache/store_folder.hpp"
#include "framework/cache/stored_stage.hpp"
#include "framework/compare/arm_keys.hpp"
#include "framework/compare/arm_record.hpp"
#include "framework/compare/merge_plans.hpp"
#include "stope/digest.hpp"
#include "stope/error.hpp"
#include "stope/payloads/measures.hpp"

namespace stope {
namespace {

/// One arm's part of a pair: the stages that are timed, and what they give.
struct Contender {
  const Plan* plan = nullptr;
  std::vector<StageKey> keys;
  std::vector<std::size_t> timed;
  std::vector<PlannedSource> outputs;
};

bool measures_alone(const PlannedStage& stage) {
  return !stage.info.outputs.empty() &&
         std::all_of(stage.info.outputs.begin(), stage.info.outputs.end(),
                     [](const PortInfo& port) { return port.type == Measures::kType; });
}

void choose_stages(Contender& contender, const MergedPlan& merged, std::size_t place) {
  const std::vector<PlannedStage>& stages = contender.plan->stages;
  std::vector<bool> timed(stages.size(), false);
  for (std::size_t i = 0; i < stages.size(); ++i) {
    if (merged.owners[merged.places[place][i]].size() > 1) continue;
    // It must not be taken from the store, whether it is timed or not.
    contender.keys[i].only_this_run = true;
    timed[i] = !stages[i].is_export && !measures_alone(stages[i]);
    if (timed[i]) contender.timed.push_back(i);
  }
  // Outputs that nobody reads are not made by the pipeline either.
  for (const PlannedStage& reader : stages)
    for (const auto& source : reader.inputs)
      if (source && timed[source->stage] &&
          std::find(contender.outputs.begin(), contender.outputs.end(), *source) ==
              contender.outputs.end())
        contender.outputs.push_back(*source);
}

class Timer {
 public:
  Timer(const CompareJob& job, std::uint64_t seed) : job_(job), seed_(seed) {
    const std::filesystem::path& root = job.options.cache.store;
    if (root.empty() || !is_store(root)) return;
    objects_.emplace(root);
    kept_.emplace(root);
  }

  /// Seconds that the timed stages took; none if the run was cancelled.
  std::optional<double> run(const Contender& contender) {
    Reuse reuse;
    if (objects_) {
      reuse = decide(*contender.plan, contender.keys, contender.outputs, *kept_, *objects_);
    } else {
      reuse.fates.resize(contender.plan->stages.size(), Fate::kRuns);
      reuse.stored.resize(contender.plan->stages.size());
    }
    std::vector<Sink> sinks;
    for (const PlannedSource& source : contender.outputs)
      sinks.push_back({fmt::format("reader {}", sinks.size()), source, [](const AnyItem&) {}, {}});
    RunOptions options;
    options.threads = job_.options.threads;
    options.memory = job_.options.memory;
    options.seed = seed_;
    options.scratch = scratch_of(job_.options.folder);
    options.stop = job_.options.stop;
    Silence silence;
    const RunRecord record = run_with(*contender.plan, reuse, sinks, options, silence);
    if (record.end == RunRecord::End::kCancelled) return std::nullopt;
    if (record.end == RunRecord::End::kFailed)
      throw Error(fmt::format("a run that was to be timed failed: {}", record.sentence));
    double seconds = 0;
    for (const std::size_t stage : contender.timed)
      seconds += busy_seconds(record.processes[stage]);
    return seconds;
  }

 private:
  struct Silence final : RunObserver {
    void log(LogLevel, const std::string&, const std::string&) override {}
  };

  RunRecord run_with(const Plan& plan, const Reuse& reuse, const std::vector<Sink>& sinks,
                     const RunOptions& options, RunObserver& observer) {
    if (!objects_) return run_plan(plan, job_.catalogue, sinks, options, observer);
    const ReusingCatalogue catalogue(plan, reuse, job_.catalogue, *objects_);
    return run_plan(with_reuse(plan, reuse), catalogue, sinks, options, observer);
  }

  const CompareJob& job_;
  std::uint64_t seed_;
  std::optional<ObjectStore> objects_;
  std::optional<KeptStages> kept_;
};

std::string key_of(const Contender (&both)[2], int threads) {
  Digester digester;
  for (const Contender& contender : both)
    for (const StageKey& key : contender.keys) encode(key.digest.text(), digester);
  encode(static_cast<std::uint64_t>(threads), digester);
  return digester.digest().text();
}

const TimedPair* find(const std::vector<TimedPair>& earlier, const TimedPair& wanted, int pairs) {
  const auto found = std::find_if(earlier.begin(), earlier.end(), [&](const TimedPair& timed) {
    return timed.key == wanted.key && timed.arm_seconds.size() >= static_cast<std::size_t>(pairs) &&
           timed.baseline_seconds.size() == timed.arm_seconds.size();
  });
  return found == earlier.end() ? nullptr : &*found;
}

struct Taken {
  std::optional<TimedPair> timed;  // none if there is nothing to time, or it was cancelled
  bool now = false;
};

Taken time_pair(const CompareJob& job, const std::vector<TimedPair>& earlier,
                const Comparison& comparison, const ComparedCell& cell) {
  const std::uint64_t seed = cell.run_seed;
  Contender both[2];
  for (const std::size_t i : {0U, 1U}) {
    both[i].plan = &*job.plan.of(i == 0 ? comparison.baseline : cell.arm, cell.recording).plan;
    both[i].keys = arm_keys(job, *both[i].plan, seed, comparison.id);
  }
  TimedPair timed{cell.arm, cell.recording, cell.seed, {}, {}, key_of(both, job.options.threads)};
  if (!job.options.time_again)
    if (const TimedPair* known = find(earlier, timed, job.experiment.timing_pairs)) {
      timed.baseline_seconds = known->baseline_seconds;
      timed.arm_seconds = known->arm_seconds;
      return {timed, false};
    }
  const MergedPlan merged = merge_plans(
      {{"baseline", both[0].plan, &both[0].keys}, {"arm", both[1].plan, &both[1].keys}});
  for (const std::size_t i : {0U, 1U}) choose_stages(both[i], merged, i);
  if (both[0].timed.empty() && both[1].timed.empty()) return {};
  Timer timer(job, seed);
  for (int pair = -1; pair < job.experiment.timing_pairs; ++pair) {
    for (const std::size_t turn : {0U, 1U}) {
      const std::size_t i = pair % 2 == 0 ? turn : 1 - turn;
      const auto seconds = timer.run(both[i]);
      if (!seconds) return {};
      if (pair >= 0) (i == 0 ? timed.baseline_seconds : timed.arm_seconds).push_back(*seconds);
    }
  }
  return {timed, true};
}

TimingSummary::Of of_sorted(std::vector<double> values) {
  if (values.empty()) return {};
  std::sort(values.begin(), values.end());
  const std::size_t half = values.size() / 2;
  const double median =
      values.size() % 2 == 1 ? values[half] : (values[half - 1] + values[half]) / 2;
  return {values.front(), median, values.back()};
}

}  // namespace

bool time_arms(const CompareJob& job, const std::vector<TimedPair>& earlier, Comparison& comparison,
               const std::function<void()>& taken) {
  comparison.timings.clear();
  if (job.experiment.timing_pairs == 0) return true;
  for (const ComparedCell& cell : comparison.cells) {
    const ComparedCell& baseline = comparison.cell(comparison.baseline, cell.recording, cell.seed);
    if (cell.arm == comparison.baseline || cell.status != CellStatus::kDone ||
        baseline.status != CellStatus::kDone)
      continue;
    try {
      Taken pair = time_pair(job, earlier, comparison, cell);
      if (pair.timed) comparison.timings.push_back(*std::move(pair.timed));
      if (pair.timed && pair.now) taken();
    } catch (const Cancelled&) {
    }
    if (job.stopping()) return false;
  }
  return true;
}

TimingSummary summary_of(const TimedPair& timed) {
  std::vector<double> ratios;
  for (std::size_t i = 0; i < timed.arm_seconds.size() && i < timed.baseline_seconds.size(); ++i)
    ratios.push_back(timed.arm_seconds[i] / timed.baseline_seconds[i]);
  return {of_sorted(timed.baseline_seconds), of_sorted(timed.arm_seconds), of_sorted(ratios)};
}

TimingSummary summary_of(const Comparison& comparison, std::size_t arm) {
  std::vector<double> baselines, arms, ratios;
  TimingSummary one;
  for (const TimedPair& timed : comparison.timings) {
    if (timed.arm != arm) continue;
    const TimingSummary of_one = summary_of(timed);
    one = of_one;
    baselines.push_back(of_one.baseline.median);
    arms.push_back(of_one.arm.median);
    ratios.push_back(of_one.ratio.median);
  }
  if (ratios.size() == 1) return one;
  return {of_sorted(baselines), of_sorted(arms), of_sorted(ratios)};
}

}  // namespace stope
