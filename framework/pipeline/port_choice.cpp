#include "framework/pipeline/port_choice.hpp"

namespace stope {

OutputChoice choose_output(const StageInfo& producer, const std::string& port,
                           const PortInfo* input) {
  const std::vector<PortInfo>& outputs = producer.outputs;
  if (!port.empty()) {
    for (std::size_t i = 0; i < outputs.size(); ++i)
      if (outputs[i].name == port) return {i, false};
    return {};
  }
  if (outputs.size() == 1) return {0, false};
  if (!input || outputs.empty()) return {std::nullopt, !outputs.empty()};
  std::optional<std::size_t> named, of_type;
  bool several = false;
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    if (outputs[i].name == input->name) named = i;
    if (outputs[i].type != input->type) continue;
    several = several || of_type;
    of_type = i;
  }
  if (named && outputs[*named].type == input->type) return {named, false};
  if (of_type && !several) return {of_type, false};
  if (named && !several) return {named, false};
  return {std::nullopt, true};
}

bool same_payload(const PortInfo& output, const PortInfo& input) {
  return output.type == input.type && output.layout == input.layout;
}

std::optional<std::size_t> choose_input(const StageInfo& reader, const std::string& name) {
  const std::vector<PortInfo>& inputs = reader.inputs;
  if (!name.empty()) {
    for (std::size_t i = 0; i < inputs.size(); ++i)
      if (inputs[i].name == name) return i;
    return std::nullopt;
  }
  std::optional<std::size_t> required;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    if (!inputs[i].required) continue;
    if (required) return std::nullopt;
    required = i;
  }
  if (required) return required;
  if (inputs.size() == 1) return 0;
  return std::nullopt;
}

}  // namespace stope
