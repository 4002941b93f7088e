#include "checked.hpp"

#include <stdexcept>

#include "fake_catalogue.hpp"

namespace stope {
namespace {

Checked finished(std::optional<Plan> plan, const Diagnostics& diagnostics) {
  Checked result{std::move(plan), diagnostics.sorted(), ""};
  for (const Diagnostic& diagnostic : result.diagnostics)
    result.text.append(to_text(diagnostic)).append("\n");
  return result;
}

template <class List>
std::size_t place_of(const List& list, const std::string& name) {
  for (std::size_t i = 0; i < list.size(); ++i)
    if (list[i].name == name) return i;
  throw std::out_of_range(name);
}

}  // namespace

const PlannedStage& Checked::stage(const std::string& name) const {
  return plan.value().stages.at(place_of(plan.value().stages, name));
}

const ParameterValue& Checked::parameter(const std::string& stage_name,
                                         const std::string& name) const {
  const PlannedStage& planned = stage(stage_name);
  return planned.parameters.at(place_of(planned.info.parameters, name));
}

std::string Checked::source(const std::string& stage_name, const std::string& input) const {
  const PlannedStage& planned = stage(stage_name);
  const auto& from = planned.inputs.at(place_of(planned.info.inputs, input));
  if (!from) return "";
  const PlannedStage& producer = plan.value().stages.at(from->stage);
  return producer.name + "." + producer.info.outputs.at(from->port).name;
}

Checked check_text(const std::string& text, const std::vector<std::string>& overrides) {
  const FakeCatalogue catalogue;
  Diagnostics diagnostics;
  auto plan = check_pipeline_text(text, "pit.yaml", overrides, catalogue, diagnostics);
  return finished(std::move(plan), diagnostics);
}

Checked check_file(const std::string& file, const std::vector<std::string>& overrides) {
  const FakeCatalogue catalogue;
  Diagnostics diagnostics;
  auto plan = check_pipeline(file, overrides, catalogue, diagnostics);
  return finished(std::move(plan), diagnostics);
}

}  // namespace stope
