#include "framework/compare/run_comparison.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>
#include <random>

#include "framework/cache/store_folder.hpp"
#include "framework/compare/arm_keys.hpp"
#include "framework/compare/comparison_json.hpp"
#include "framework/compare/earlier_cells.hpp"
#include "framework/compare/equal_arms.hpp"
#include "framework/compare/equal_recordings.hpp"
#include "framework/compare/group_run.hpp"
#include "framework/compare/metric_check.hpp"
#include "framework/compare/new_comparison.hpp"
#include "framework/compare/remarks.hpp"
#include "framework/compare/source_contents.hpp"
#include "framework/compare/timing.hpp"
#include "framework/report/folder_lock.hpp"
#include "framework/report/pending_file.hpp"
#include "framework/report/run_json.hpp"
#include "stope/error.hpp"

namespace stope {
namespace {

constexpr const char* kFile = "comparison.json";

std::string now() { return report::utc_text(std::chrono::system_clock::now()); }

class ComparisonRun {
 public:
  explicit ComparisonRun(const CompareJob& job)
      : job_(job),
        lock_(made(job.options.folder)),
        comparison_(new_comparison(job)),
        metrics_(job.experiment, job.plan) {
    remove_scratch();
    const EarlierCells earlier(job_);
    timed_before_ = earlier.timings();
    comparison_.id = earlier.id();
    comparison_.started = now();
    name_keys();
    const std::size_t kept = earlier.take_over(comparison_);
    for (const ComparedCell& cell : comparison_.cells)
      for (std::size_t i = 0; i < cell.measures.size(); ++i)
        if (std::isfinite(cell.measures[i])) metrics_.was_read(i);
    if (kept > 0)
      job_.observer.log(LogLevel::kInfo, "",
                        fmt::format("{} of {} runs were done before and are kept", kept,
                                    comparison_.cells.size()));
    if (kept < comparison_.cells.size()) warn_of_too_few();
    if (!std::filesystem::exists(job_.options.folder / kFile)) save();
  }

  Comparison run() {
    const std::size_t groups = comparison_.recordings.size() * comparison_.seeds.size();
    bool stopped = false;
    for (std::size_t group = 0; group < groups && !stopped; ++group)
      stopped = !run_next(group, groups);
    if (!stopped) stopped = !time_arms(job_, timed_before_, comparison_, [this] { save(); });
    note_equal_arms(comparison_);
    note_equal_recordings(comparison_, source_keys(kept_stages().get()));
    comparison_.complete = !stopped;
    if (!stopped) comparison_.ended = now();
    save();
    return std::move(comparison_);
  }

 private:
  static const std::filesystem::path& made(const std::filesystem::path& folder) {
    std::error_code error;
    if (std::filesystem::exists(folder, error)) require_own(folder);
    std::filesystem::create_directories(folder, error);
    if (error) throw Error(report::io_sentence("make the folder", folder, error.value()));
    return folder;
  }

  // A report, tables and `arms` would be written over what somebody else keeps there.
  static void require_own(const std::filesystem::path& folder) {
    if (std::filesystem::exists(folder / kFile)) return;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(folder, error))
      if (!is_left_by_stope(entry.path().filename().string()))
        throw Error(
            fmt::format("{} is neither empty nor the folder of a comparison: there is '{}' in it, "
                        "and no {}. Choose another folder with --out.",
                        folder.string(), entry.path().filename().string(), kFile));
    if (error) throw Error(report::io_sentence("read the folder", folder, error.value()));
  }

  // Before there is a comparison.json.
  static bool is_left_by_stope(const std::string& name) {
    return name.starts_with('.') && name.ends_with(report::kPendingSuffix);
  }

  // Before hours are spent on it.
  void warn_of_too_few() const {
    const std::string remark = expected_remark(comparison_);
    if (!remark.empty()) job_.observer.log(LogLevel::kWarning, "", remark);
  }

  // What a comparison that was killed left; the lock says that it is gone.
  void remove_scratch() const {
    std::error_code ignored;
    std::filesystem::remove_all(scratch_of(job_.options.folder), ignored);
  }

  // Also decides which cells are equal, before anything runs.
  void name_keys() {
    sources_.resize(comparison_.cells.size());
    for (ComparedCell& cell : comparison_.cells) {
      if (cell.status != CellStatus::kPending) continue;
      const PlannedArm& arm = job_.plan.of(cell.arm, cell.recording);
      const std::vector<StageKey> keys = arm_keys(
          job_, *arm.plan, job_.experiment.seed_of(cell.recording, cell.seed), comparison_.id);
      cell.key = cell_key(job_.experiment, arm, keys);
      sources_[comparison_.place(cell.arm, cell.recording, cell.seed)] =
          sources_of(*arm.plan, keys);
    }
    note_equal_arms(comparison_);
    note_equal_recordings(comparison_, source_keys(nullptr));
    for (const std::string& warning : comparison_.warnings)
      job_.observer.log(LogLevel::kWarning, "", warning);
  }

  // What the store knows of the stages that have run; none without one.
  std::unique_ptr<KeptStages> kept_stages() const {
    const std::filesystem::path& store = job_.options.cache.store;
    if (store.empty() || !is_store(store)) return nullptr;
    return std::make_unique<KeptStages>(store);
  }

  SourceKeys source_keys(const KeptStages* kept) const {
    SourceKeys keys;
    for (const CellSources& sources : sources_) keys.push_back(contents_key(sources, kept));
    return keys;
  }

  bool run_next(std::size_t group, std::size_t groups) {
    const std::size_t recording = group / comparison_.seeds.size();
    const std::size_t seed = group % comparison_.seeds.size();
    std::size_t pending = 0;
    for (std::size_t arm = 0; arm < comparison_.arms.size(); ++arm)
      pending += comparison_.cell(arm, recording, seed).status == CellStatus::kPending ? 1 : 0;
    if (pending == 0) return true;
    const auto begin = std::chrono::steady_clock::now();
    const bool done = !job_.stopping() && run_group(job_, recording, seed, metrics_, comparison_);
    save();
    if (!done) return false;
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    job_.observer.log(
        LogLevel::kInfo, "",
        fmt::format("{}/{} {}, seed {}: {} in {:.1f} s", group + 1, groups,
                    comparison_.recordings[recording].name,
                    job_.experiment.seed_of(recording, seed),
                    pending == 1 ? "one arm" : fmt::format("{} arms", pending), took.count()));
    return true;
  }

  void save() const {
    report::write_file(job_.options.folder / kFile, comparison_json(comparison_));
  }

  const CompareJob& job_;
  report::FolderLock lock_;
  Comparison comparison_;
  MetricCheck metrics_;
  std::vector<CellSources> sources_;  ///< by cell
  std::vector<TimedPair> timed_before_;
};

}  // namespace

Comparison run_comparison(const CompareJob& job) {
  try {
    return ComparisonRun(job).run();
  } catch (const Cancelled&) {
    // While files were read for their keys: nothing has changed yet.
    return new_comparison(job);
  }
}

}  // namespace stope
