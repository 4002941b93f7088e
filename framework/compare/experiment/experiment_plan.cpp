#include "framework/compare/experiment/experiment_plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>

#include "framework/compare/experiment/codes.hpp"
#include "framework/compare/experiment/metric_source.hpp"
#include "framework/pipeline/check.hpp"
#include "framework/pipeline/codes.hpp"
#include "framework/pipeline/path_check.hpp"
#include "framework/pipeline/sentence.hpp"

namespace stope {
namespace {

/// Something the checks had to say, and of which pairs of arm and recording.
struct Found {
  Diagnostic diagnostic;
  std::set<std::size_t> arms, recordings;
};

class Planner {
 public:
  Planner(const Experiment& experiment, const Catalogue& catalogue)
      : experiment_(experiment), catalogue_(catalogue) {}

  std::optional<ExperimentPlan> plan(Diagnostics& diagnostics) {
    ExperimentPlan made;
    made.arms = experiment_.arms.size();
    for (std::size_t recording = 0; recording < experiment_.recordings.size(); ++recording)
      for (std::size_t arm = 0; arm < experiment_.arms.size(); ++arm)
        made.all.push_back(plan_arm(arm, recording));
    bool wrong = false;
    for (const Found& found : found_) {
      if (found.diagnostic.severity == Severity::kError) {
        wrong = true;
        diagnostics.error(found.diagnostic.code, found.diagnostic.place, sentence_of(found),
                          found.diagnostic.hint);
      } else {
        made.warnings.push_back(
            fmt::format("{}: {}", to_text(found.diagnostic.place), sentence_of(found)));
      }
    }
    for (std::size_t arm = 0; arm < made.arms && !wrong; ++arm)
      require_runs(arm, made, diagnostics);
    if (wrong || diagnostics.has_errors()) return std::nullopt;
    return made;
  }

 private:
  PlannedArm plan_arm(std::size_t arm, std::size_t recording) {
    const Variant& variant = experiment_.arms[arm];
    Diagnostics diagnostics;
    std::vector<Override> changes = experiment_.overrides;
    for (const auto* more : {&experiment_.recordings[recording].overrides, &variant.overrides})
      changes.insert(changes.end(), more->begin(), more->end());
    const auto base =
        variant.base ? absolute_path(variant.base->text, variant.base->folder) : experiment_.base;
    const Place& asked = variant.base ? variant.base->place : experiment_.base_place;
    PlannedArm planned;
    planned.plan = check_pipeline(base, asked, changes, catalogue_, diagnostics);
    if (!planned.plan) planned.why_not = only_missing_data(diagnostics);
    if (planned.plan)
      for (const ExperimentMetric& metric : experiment_.metrics)
        planned.metrics.push_back(metric_source(metric, *planned.plan, diagnostics));
    if (planned.why_not.empty())
      for (const Diagnostic& diagnostic : diagnostics.sorted())
        if (!of_a_metric(diagnostic, planned)) note(diagnostic, arm, recording);
    return planned;
  }

  // That nothing reads a stage is not so if a metric does.
  static bool of_a_metric(const Diagnostic& diagnostic, const PlannedArm& planned) {
    return diagnostic.code == code::kUnread && planned.plan &&
           std::any_of(planned.metrics.begin(), planned.metrics.end(),
                       [&](const PlannedSource& source) {
                         return to_text(planned.plan->stages[source.stage].place) ==
                                to_text(diagnostic.place);
                       });
  }

  // The first sentence, if all that is wrong is that data is not there: files, or the variable of
  // the environment that tells where they are.
  static std::string only_missing_data(const Diagnostics& diagnostics) {
    std::string first;
    for (const Diagnostic& found : diagnostics.sorted()) {
      if (found.severity != Severity::kError) continue;
      if (found.code != code::kMissingPath && found.code != code::kUndefinedVariable) return {};
      if (first.empty()) first = joined(found.sentence, found.hint);
    }
    return first;
  }

  void note(const Diagnostic& diagnostic, std::size_t arm, std::size_t recording) {
    const auto same = std::find_if(found_.begin(), found_.end(), [&](const Found& found) {
      return to_text(found.diagnostic) == to_text(diagnostic);
    });
    Found& found = same == found_.end() ? found_.emplace_back(Found{diagnostic, {}, {}}) : *same;
    found.arms.insert(arm);
    found.recordings.insert(recording);
  }

  static std::string names(const std::set<std::size_t>& places,
                           const std::vector<Variant>& variants) {
    std::vector<std::string> list;
    for (const std::size_t place : places) list.push_back(variants[place].name);
    return quoted_list(list, "and", 4);
  }

  std::string sentence_of(const Found& found) const {
    std::string where;
    if (found.arms.size() < experiment_.arms.size())
      where = fmt::format("{} {}", found.arms.size() == 1 ? "arm" : "arms",
                          names(found.arms, experiment_.arms));
    if (found.recordings.size() < experiment_.recordings.size())
      where += fmt::format("{}{} {}", where.empty() ? "" : " on ",
                           found.recordings.size() == 1 ? "recording" : "recordings",
                           names(found.recordings, experiment_.recordings));
    return where.empty() ? found.diagnostic.sentence
                         : fmt::format("In {}: {}", where, found.diagnostic.sentence);
  }

  void require_runs(std::size_t arm, const ExperimentPlan& made, Diagnostics& diagnostics) const {
    for (std::size_t recording = 0; recording < experiment_.recordings.size(); ++recording)
      if (made.of(arm, recording).plan) return;
    diagnostics.error(
        code::kNothingToRun, experiment_.arms[arm].place,
        fmt::format("The arm '{}' lacks every recording. On '{}': {}", experiment_.arms[arm].name,
                    experiment_.recordings[0].name, made.of(arm, 0).why_not));
  }

  const Experiment& experiment_;
  const Catalogue& catalogue_;
  std::vector<Found> found_;
};

}  // namespace

std::size_t comparable_recordings(const Experiment& experiment, const ExperimentPlan& plan) {
  std::size_t most = 0;
  for (std::size_t arm = 0; arm < plan.arms; ++arm) {
    std::size_t common = 0;
    for (std::size_t recording = 0; recording < experiment.recordings.size(); ++recording)
      if (plan.of(arm, recording).plan && plan.of(experiment.baseline, recording).plan) ++common;
    if (arm != experiment.baseline) most = std::max(most, common);
  }
  return most;
}

std::optional<ExperimentPlan> plan_experiment(const Experiment& experiment,
                                              const Catalogue& catalogue,
                                              Diagnostics& diagnostics) {
  return Planner(experiment, catalogue).plan(diagnostics);
}

}  // namespace stope
