#include "framework/compare/group_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <map>
#include <memory>
#include <set>
#include <utility>

#include "framework/compare/arm_keys.hpp"
#include "framework/compare/arm_record.hpp"
#include "framework/compare/cell_run.hpp"
#include "framework/compare/merge_plans.hpp"
#include "framework/compare/new_comparison.hpp"
#include "framework/pipeline/variables.hpp"
#include "stope/error.hpp"

namespace stope {
namespace {

/// Passes what stages say to the logs of the cells they belong to.
class Narrator final : public RunObserver {
 public:
  Narrator(RunObserver& observer, const MergedPlan& merged,
           const std::vector<std::unique_ptr<CellRun>>& cells)
      : observer_(observer), cells_(cells), merged_(merged) {
    for (std::size_t i = 0; i < merged.plan.stages.size(); ++i)
      place_of_[merged.plan.stages[i].name] = i;
  }
  void log(LogLevel level, const std::string& stage, const std::string& sentence) override {
    if (level >= LogLevel::kWarning) observer_.log(level, stage, sentence);
    const auto place = place_of_.find(stage);
    if (place == place_of_.end()) return;
    for (const std::size_t arm : merged_.owners[place->second])
      cells_[arm]->log(level, merged_.plan.stages[place->second].seed_name(), sentence);
  }

 private:
  RunObserver& observer_;
  const std::vector<std::unique_ptr<CellRun>>& cells_;
  const MergedPlan& merged_;
  std::map<std::string, std::size_t> place_of_;
};

/// The cells of one recording and seed that are pending. In it, arms are places in `cells_`.
class GroupRun {
 public:
  GroupRun(const CompareJob& job, std::size_t recording, std::size_t seed, MetricCheck& metrics,
           Comparison& comparison)
      : job_(job), metrics_(metrics), comparison_(comparison), seed_(comparison.seeds[seed]) {
    if (const auto& own = job.experiment.recordings[recording].seed) seed_ = *own;
    for (std::size_t arm = 0; arm < comparison.arms.size(); ++arm) {
      ComparedCell& cell = comparison.cell(arm, recording, seed);
      if (cell.status != CellStatus::kPending) continue;
      const PlannedArm& planned = job.plan.of(arm, recording);
      cells_.push_back(std::make_unique<CellRun>(job.experiment, planned, job.catalogue,
                                                 facts_of(arm, recording), metrics, comparison,
                                                 cell));
      planned_.push_back(&planned);
      names_.push_back(comparison.arms[arm].name);
    }
  }

  bool run() {
    std::vector<std::vector<StageKey>> keys;
    std::vector<PlanToMerge> plans;
    for (const auto& cell : cells_)
      keys.push_back(arm_keys(job_, cell->plan(), seed_, comparison_.id));
    for (std::size_t arm = 0; arm < cells_.size(); ++arm) {
      plans.push_back({names_[arm], &cells_[arm]->plan(), &keys[arm]});
      // Files may have changed since the comparison began.
      cells_[arm]->cell().key = cell_key(job_.experiment, *planned_[arm], keys[arm]);
    }
    const MergedPlan all = merge_plans(plans);
    // A run that was stopped, because a stage could not even be made, is repeated without its arms.
    while (failed_.size() < cells_.size()) {
      const MergedPlan merged = without_arms(all, failed_);
      Narrator narrator(job_.observer, merged, cells_);
      CachedRun cached(merged.plan, job_.catalogue, seed_, job_.options.cache, narrator,
                       job_.options.stop);
      RunRecord record = run(merged, cached);
      note_seconds(merged, cached, record);
      forget_wrong_keys(merged, cached, keys);
      metrics_.require_hope();
      if (record.end == RunRecord::End::kCancelled) return false;
      if (!cached.complaint().empty()) warn_of_store(cached.complaint());
      if (record.end == RunRecord::End::kFailed) fail_owners(merged, record);
      if (record.stopped) continue;
      finish(merged, cached, std::move(record));
      return true;
    }
    return true;
  }

 private:
  RunFacts facts_of(std::size_t arm, std::size_t recording) const {
    RunFacts facts;
    facts.version = job_.options.version;
    facts.command = job_.options.command;
    facts.overrides = overrides_of(arm, recording);
    facts.working_folder = std::filesystem::absolute(job_.experiment.file).parent_path();
    facts.threads = job_.options.threads;
    facts.memory = job_.options.memory;
    facts.seed = seed_;
    return facts;
  }

  // As the command line of `stope run` would have them, so that the run can be replayed. The seed
  // of a recording is not among them: it is the run's.
  std::vector<std::string> overrides_of(std::size_t arm, std::size_t recording) const {
    std::vector<Override> all;
    for (const auto* list :
         {&job_.experiment.overrides, &job_.experiment.recordings[recording].overrides,
          &job_.experiment.arms[arm].overrides})
      for (const Override& change : *list) {
        std::erase_if(all, [&](const Override& earlier) { return earlier.key == change.key; });
        all.push_back(change);
      }
    return texts_of(all);
  }

  template <class F>
  void for_each_left(F&& visit) {
    for (std::size_t arm = 0; arm < cells_.size(); ++arm)
      if (!failed_.contains(arm)) visit(arm, *cells_[arm]);
  }

  RunRecord run(const MergedPlan& merged, CachedRun& cached) {
    std::vector<PlannedSource> wanted;
    for_each_left([&](std::size_t arm, CellRun& cell) {
      for (const PlannedSource& source : cell.wanted())
        wanted.push_back(merged.source(arm, source));
    });
    RunOptions options;
    options.threads = job_.options.threads;
    options.memory = job_.options.memory;
    options.scratch = scratch_of(job_.options.folder);
    options.go_on_after_failure = true;
    std::atomic<bool> stop{false};
    options.stop = &stop;
    return cached.run(
        wanted, [&](const Reuse&) { return sinks(merged); }, options,
        [&](const RunProgress&) { stop = stop || job_.stopping() || metrics_.hopeless(); });
  }

  std::vector<Sink> sinks(const MergedPlan& merged) {
    std::vector<Sink> all;
    owner_of_sink_.clear();
    for_each_left([&](std::size_t arm, CellRun& cell) {
      for (Sink& sink : cell.sinks()) {
        sink.name = names_[arm] + ": " + sink.name;
        sink.source = merged.source(arm, sink.source);
        owner_of_sink_[sink.name] = arm;
        all.push_back(std::move(sink));
      }
    });
    return all;
  }

  // Once: a disk that is full is full for all that follow.
  void warn_of_store(const std::string& complaint) {
    constexpr const char* kWhat = "not all could be taken from the store or kept in it";
    std::vector<std::string>& warnings = comparison_.warnings;
    if (std::any_of(warnings.begin(), warnings.end(),
                    [&](const std::string& warning) { return warning.starts_with(kWhat); }))
      return;
    warnings.push_back(fmt::format(
        "{}: {}. The results are complete; some are computed again if this is gone on with", kWhat,
        complaint));
    job_.observer.log(LogLevel::kWarning, "", warnings.back());
  }

  // Of those that are left.
  void finish(const MergedPlan& merged, const CachedRun& cached, RunRecord record) {
    record.end = RunRecord::End::kDone;
    record.sentence.clear();
    record.failed_stage.clear();
    record.failures.clear();
    for_each_left([&](std::size_t arm, CellRun& cell) {
      cell.cell().stages = cell_stages(merged, arm, cell.plan(), cached, record, seconds_);
      cell.finish(record_of_arm(merged, arm, names_[arm], cell.plan(), record),
                  reuse_of_arm(merged, arm, cached));
    });
  }

  // A stage that is stored in a second attempt was computed in the first.
  void note_seconds(const MergedPlan& merged, const CachedRun& cached, const RunRecord& record) {
    for (std::size_t i = 0; i < merged.plan.stages.size(); ++i) {
      if (cached.reuse().fates.size() <= i || cached.reuse().fates[i] != Fate::kRuns) continue;
      if (i < record.processes.size())
        seconds_[cached.keys()[i].digest] += busy_seconds(record.processes[i]);
    }
  }

  // A cell whose input files changed while it was computed, or just before, must not pass for a
  // result of what its key tells when the comparison is gone on with.
  void forget_wrong_keys(const MergedPlan& merged, const CachedRun& cached,
                         const std::vector<std::vector<StageKey>>& keys) {
    for_each_left([&](std::size_t arm, CellRun& cell) {
      for (std::size_t i = 0; i < keys[arm].size(); ++i) {
        const std::size_t place = merged.places[arm][i];
        const bool same =
            keys[arm][i].only_this_run || keys[arm][i].digest == cached.keys()[place].digest;
        if (!same || !cached.inputs_hold(place)) cell.cell().key.clear();
      }
    });
  }

  // In the order of the plan, so that of several things that went wrong in an arm the same is told
  // whichever came first.
  void fail_owners(const MergedPlan& merged, const RunRecord& record) {
    const std::size_t before = failed_.size();
    const auto failure_of = [&](const std::string& stage) {
      return std::find_if(record.failures.begin(), record.failures.end(),
                          [&](const StageFailure& failure) { return failure.stage == stage; });
    };
    for (std::size_t i = 0; i < merged.plan.stages.size(); ++i)
      if (const auto failure = failure_of(merged.plan.stages[i].name);
          failure != record.failures.end())
        for (const std::size_t arm : merged.owners[i])
          fail(merged, arm, merged.plan.stages[i].seed_name(), failure->sentence, record);
    for (const auto& [sink, arm] : owner_of_sink_)
      if (const auto failure = failure_of(sink); failure != record.failures.end())
        fail(merged, arm, sink, failure->sentence, record);
    if (failed_.size() == before) throw Error(record.sentence);
  }

  void fail(const MergedPlan& merged, std::size_t arm, const std::string& stage,
            const std::string& sentence, const RunRecord& record) {
    if (!failed_.insert(arm).second) return;
    RunRecord of_arm = record_of_arm(merged, arm, names_[arm], cells_[arm]->plan(), record);
    of_arm.failed_stage = stage;
    of_arm.sentence = sentence;
    of_arm.failures = {{stage, sentence}};
    cells_[arm]->fail(of_arm);
  }

  const CompareJob& job_;
  MetricCheck& metrics_;
  Comparison& comparison_;
  std::uint64_t seed_;
  std::vector<std::unique_ptr<CellRun>> cells_;
  std::vector<const PlannedArm*> planned_;
  std::vector<std::string> names_;
  std::set<std::size_t> failed_;
  std::map<std::string, std::size_t> owner_of_sink_;
  std::map<Digest, double> seconds_;
};

}  // namespace

bool run_group(const CompareJob& job, std::size_t recording, std::size_t seed, MetricCheck& metrics,
               Comparison& comparison) {
  try {
    return GroupRun(job, recording, seed, metrics, comparison).run();
  } catch (const Cancelled&) {
    return false;
  }
}

}  // namespace stope
