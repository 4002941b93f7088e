#include "framework/compare/new_comparison.hpp"

#include <fmt/format.h>

#include <utility>

#include "framework/pipeline/parameter_text.hpp"
#include "framework/pipeline/variables.hpp"
#include "framework/report/port_name.hpp"

namespace stope {
namespace {

// What is wired, and the parameters that are not as they would be by themselves.
std::string line_of(const Plan& plan, const PlannedStage& stage) {
  std::string inputs, parameters;
  for (std::size_t i = 0; i < stage.inputs.size(); ++i)
    if (stage.inputs[i])
      inputs += fmt::format("{}{}: {}", inputs.empty() ? "" : ", ", stage.info.inputs[i].name,
                            report::port_name(plan, *stage.inputs[i]));
  for (std::size_t i = 0; i < stage.parameters.size(); ++i) {
    const ParameterInfo& info = stage.info.parameters[i];
    if (stage.parameters[i] == info.default_value) continue;
    parameters += fmt::format("{}{}: {}", parameters.empty() ? "" : ", ", info.name,
                              value_text(stage.parameters[i], info.unit));
  }
  return fmt::format("{} = {}({}{}{})", stage.name, stage.info.id, inputs,
                     inputs.empty() || parameters.empty() ? "" : "; ", parameters);
}

ComparedArm arm_of(const CompareJob& job, std::size_t arm) {
  ComparedArm made{
      job.experiment.arms[arm].name, texts_of(job.experiment.arms[arm].overrides), {}, {}};
  for (std::size_t recording = 0; recording < job.experiment.recordings.size(); ++recording) {
    const auto& plan = job.plan.of(arm, recording).plan;
    if (!plan) continue;
    for (const PlannedStage& stage : plan->stages) made.plan.push_back(line_of(*plan, stage));
    break;
  }
  return made;
}

ComparedRecording recording_of(const Variant& variant) {
  ComparedRecording made{variant.name, texts_of(variant.overrides), {}};
  if (variant.seed) made.overrides.push_back(fmt::format("seed={}", *variant.seed));
  return made;
}

ComparedMetric metric_of(const ExperimentMetric& metric) {
  return {metric.name,
          metric.port.empty() ? metric.stage : metric.stage + "." + metric.port,
          metric.measure,
          metric.direction,
          metric.smallest_that_matters.number,
          metric.smallest_that_matters.unit};
}

void exclude_what_is_missing(const CompareJob& job, Comparison& comparison) {
  for (ComparedCell& cell : comparison.cells) {
    cell.run_seed = job.experiment.seed_of(cell.recording, cell.seed);
    cell.folder = fmt::format("arms/{}/{}/{}", comparison.arms[cell.arm].name,
                              comparison.recordings[cell.recording].name, cell.run_seed);
    const PlannedArm& planned = job.plan.of(cell.arm, cell.recording);
    if (planned.plan) continue;
    cell.status = CellStatus::kExcluded;
    cell.sentence = planned.why_not;
    comparison.exclusions.push_back({comparison.arms[cell.arm].name,
                                     comparison.recordings[cell.recording].name, cell.run_seed, "",
                                     planned.why_not});
  }
}

}  // namespace

std::vector<std::string> texts_of(const std::vector<Override>& overrides) {
  std::vector<std::string> texts;
  for (const Override& change : overrides)
    texts.push_back(change.key + "=" + flow_text(change.value));
  return texts;
}

Comparison new_comparison(const CompareJob& job) {
  Comparison comparison;
  comparison.name = job.experiment.name;
  comparison.file = job.experiment.file;
  comparison.base = job.experiment.base;
  comparison.folder = job.options.folder;
  comparison.version = job.options.version;
  comparison.threads = job.options.threads;
  comparison.baseline = job.experiment.baseline;
  comparison.seeds = job.experiment.seeds;
  comparison.set = texts_of(job.experiment.overrides);
  for (std::size_t arm = 0; arm < job.experiment.arms.size(); ++arm)
    comparison.arms.push_back(arm_of(job, arm));
  for (const Variant& recording : job.experiment.recordings)
    comparison.recordings.push_back(recording_of(recording));
  for (const ExperimentMetric& metric : job.experiment.metrics)
    comparison.metrics.push_back(metric_of(metric));
  comparison.warnings = job.plan.warnings;
  comparison.cells = empty_cells(comparison);
  exclude_what_is_missing(job, comparison);
  return comparison;
}

}  // namespace stope
