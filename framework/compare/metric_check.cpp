#include "framework/compare/metric_check.hpp"

#include <algorithm>
#include <utility>

#include "framework/compare/experiment/codes.hpp"
#include "framework/compare/measure_reading.hpp"

namespace stope {
namespace {

std::string text_of(const std::vector<Diagnostic>& diagnostics) {
  std::string text;
  for (const Diagnostic& diagnostic : diagnostics) {
    if (!text.empty()) text += '\n';
    text += to_text(diagnostic);
  }
  return text;
}

}  // namespace

WrongExperiment::WrongExperiment(std::vector<Diagnostic> diagnostics)
    : Error(text_of(diagnostics)), diagnostics_(std::move(diagnostics)) {}

MetricCheck::MetricCheck(const Experiment& experiment, const ExperimentPlan& plan)
    : experiment_(experiment), plan_(plan), hopes_(experiment.metrics.size()) {
  for (std::size_t metric = 0; metric < hopes_.size(); ++metric) {
    Hope& hope = hopes_[metric];
    for (const PlannedArm& planned : plan.all) {
      hope.kind_of.push_back(hope.kinds.size());
      if (!planned.plan) continue;
      const PlannedSource& source = planned.metrics[metric];
      const Kind kind{&planned.plan->stages[source.stage], source.port};
      const auto known = std::find_if(hope.kinds.begin(), hope.kinds.end(),
                                      [&](const Kind& other) { return alike(kind, other); });
      hope.kind_of.back() = static_cast<std::size_t>(known - hope.kinds.begin());
      if (known == hope.kinds.end()) hope.kinds.push_back(kind);
    }
  }
}

bool MetricCheck::alike(const Kind& kind, const Kind& other) {
  const auto wired_alike = [](const auto& a, const auto& b) {
    return a.has_value() == b.has_value();
  };
  return kind.stage->info.id == other.stage->info.id && kind.port == other.port &&
         kind.stage->parameters == other.stage->parameters &&
         std::equal(kind.stage->inputs.begin(), kind.stage->inputs.end(),
                    other.stage->inputs.begin(), other.stage->inputs.end(), wired_alike);
}

bool MetricCheck::hopeless(const Hope& hope) const {
  return !hope.fulfilled && std::all_of(hope.kinds.begin(), hope.kinds.end(),
                                        [](const Kind& kind) { return kind.told; });
}

void MetricCheck::look(std::size_t arm, std::size_t recording, std::size_t metric,
                       const Measures& measures) {
  const ExperimentMetric& asked = experiment_.metrics[metric];
  const Figure figure = find_figure(asked, measures, asked.stage);
  const std::lock_guard lock(mutex_);
  Hope& hope = hopes_[metric];
  if (!figure.wrong) {
    hope.fulfilled = true;
    return;
  }
  hope.kinds[hope.kind_of[recording * plan_.arms + arm]].told = true;
  hope.complaint = {
      Severity::kError, figure.wrong,
      figure.wrong == code::kUnknownFigure ? asked.measure_place : asked.matters_place,
      figure.sentence, figure.hint};
  if (hopeless(hope)) hopeless_ = true;
}

void MetricCheck::was_read(std::size_t metric) {
  const std::lock_guard lock(mutex_);
  hopes_[metric].fulfilled = true;
}

void MetricCheck::require_hope() const {
  const std::lock_guard lock(mutex_);
  std::vector<Diagnostic> wrong;
  for (const Hope& hope : hopes_)
    if (hopeless(hope)) wrong.push_back(hope.complaint);
  if (!wrong.empty()) throw WrongExperiment(std::move(wrong));
}

}  // namespace stope
