#include "framework/compare/experiment/metric_source.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "framework/compare/experiment/codes.hpp"
#include "framework/pipeline/sentence.hpp"
#include "stope/payloads/measures.hpp"

namespace stope {
namespace {

// Which stages of a plan could be meant.
std::vector<std::string> stages_with_measures(const Plan& plan) {
  std::vector<std::string> names;
  for (const PlannedStage& stage : plan.stages)
    if (std::any_of(stage.info.outputs.begin(), stage.info.outputs.end(),
                    [](const PortInfo& port) { return port.type == Measures::kType; }))
      names.push_back(stage.name);
  return names;
}

std::string those(const std::vector<std::string>& names) {
  return names.empty() ? "No stage of this pipeline gives measures; add one of the metric/ family."
                       : fmt::format("Measures come from {}.", quoted_list(names));
}

}  // namespace

PlannedSource metric_source(const ExperimentMetric& metric, const Plan& plan,
                            Diagnostics& diagnostics) {
  const auto refuse = [&](const char* code, std::string sentence, std::string hint) {
    diagnostics.error(code, metric.stage_place, std::move(sentence), std::move(hint));
    return PlannedSource{};
  };
  const std::vector<std::string> measuring = stages_with_measures(plan);
  const auto stage =
      std::find_if(plan.stages.begin(), plan.stages.end(),
                   [&](const PlannedStage& s) { return !s.is_export && s.name == metric.stage; });
  if (stage == plan.stages.end())
    return refuse(code::kUnknownMetricStage,
                  fmt::format("The metric '{}' is read from a stage '{}', which the pipeline does "
                              "not have.",
                              metric.name, shown(metric.stage)),
                  did_you_mean(metric.stage, measuring, those(measuring)));
  std::vector<std::size_t> ports;
  std::vector<std::string> names;
  for (std::size_t port = 0; port < stage->info.outputs.size(); ++port) {
    const PortInfo& info = stage->info.outputs[port];
    if (info.type != Measures::kType) continue;
    names.push_back(metric.stage + "." + info.name);
    if (metric.port.empty() || metric.port == info.name) ports.push_back(port);
  }
  if (ports.empty())
    return refuse(
        code::kNotMeasures,
        metric.port.empty() || names.empty()
            ? fmt::format("Stage '{}' ({}) gives no measures.", metric.stage, stage->info.id)
            : fmt::format("Stage '{}' ({}) has no output '{}' with measures.", metric.stage,
                          stage->info.id, shown(metric.port)),
        names.empty() ? those(measuring)
                      : did_you_mean(metric.stage + "." + metric.port, names,
                                     fmt::format("It has {}.", quoted_list(names))));
  if (ports.size() > 1)
    return refuse(code::kNotMeasures,
                  fmt::format("Stage '{}' has several outputs with measures.", metric.stage),
                  fmt::format("Write one of {}.", quoted_list(names, "or")));
  const PlannedSource source{static_cast<std::size_t>(stage - plan.stages.begin()), ports[0]};
  if (stage->streams[source.port])
    return refuse(code::kNotMeasures,
                  fmt::format("Stage '{}' gives a stream of measures, and a metric is one number "
                              "a run.",
                              metric.stage),
                  "Measure a single value, such as the last map.");
  return source;
}

}  // namespace stope
