#include "framework/plugins/manifest_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <string_view>

#include "framework/plugins/plugin_file.hpp"

namespace stope {

namespace {

[[noreturn]] void refuse(const StageInfo& stage, const std::string& what) {
  throw PluginRefused(PluginStatus::kInvalid,
                      fmt::format("Its stage '{}' is declared wrongly: {}.", stage.id, what));
}

/// Lower-case words joined by underscores.
bool is_snake_case(std::string_view text) {
  if (text.empty() || text.front() < 'a' || text.front() > 'z') return false;
  return std::all_of(text.begin(), text.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '_';
  });
}

/// `family/name`.
bool is_stage_id(std::string_view id) {
  const std::size_t slash = id.find('/');
  return slash != std::string_view::npos && is_snake_case(id.substr(0, slash)) &&
         is_snake_case(id.substr(slash + 1));
}

/// `vendor/Name@version`.
bool is_payload_type(std::string_view type) {
  const std::size_t slash = type.find('/');
  const std::size_t at = type.find('@');
  if (slash == std::string_view::npos || at == std::string_view::npos || at < slash + 2)
    return false;
  const std::string_view version = type.substr(at + 1);
  return is_snake_case(type.substr(0, slash)) && !version.empty() &&
         std::all_of(version.begin(), version.end(), [](char c) { return c >= '0' && c <= '9'; });
}

void check_ports(const StageInfo& stage, const std::vector<PortInfo>& ports,
                 const std::string& kind) {
  std::set<std::string> names;
  for (const PortInfo& port : ports) {
    if (!is_snake_case(port.name)) {
      refuse(stage, fmt::format("the {} '{}' is not named in snake_case", kind, port.name));
    }
    if (!names.insert(port.name).second) {
      refuse(stage, fmt::format("two {}s are named '{}'", kind, port.name));
    }
    if (!is_payload_type(port.type)) {
      refuse(stage, fmt::format("the {} '{}' carries '{}', which is not of the form vendor/Name@1",
                                kind, port.name, port.type));
    }
  }
}

/// Whether a value is of the alternative that its kind asks for.
bool fits_kind(const ParameterValue& value, ParameterKind kind) {
  switch (kind) {
    case ParameterKind::kBool:
      return std::holds_alternative<bool>(value);
    case ParameterKind::kInteger:
      return std::holds_alternative<std::int64_t>(value);
    case ParameterKind::kReal:
      return std::holds_alternative<double>(value);
    case ParameterKind::kText:
    case ParameterKind::kPath:
      return std::holds_alternative<std::string>(value);
    case ParameterKind::kReals:
      return std::holds_alternative<std::vector<double>>(value);
    case ParameterKind::kTexts:
      return std::holds_alternative<std::vector<std::string>>(value);
  }
  return false;
}

bool is_within(double value, const Limits& limits) {
  if (limits.least && !(limits.least_excluded ? value > *limits.least : value >= *limits.least)) {
    return false;
  }
  return !limits.most || (limits.most_excluded ? value < *limits.most : value <= *limits.most);
}

void check_default(const StageInfo& stage, const ParameterInfo& parameter) {
  const ParameterValue& value = parameter.default_value;
  if (std::holds_alternative<std::monostate>(value) && parameter.optional) return;
  if (!fits_kind(value, parameter.kind)) {
    refuse(stage,
           fmt::format("the default of '{}' is not of the parameter's kind", parameter.name));
  }
  const Limits& limits = parameter.limits;
  if (limits.required) return;  // its default is never used
  std::vector<double> numbers;
  if (const auto* integer = std::get_if<std::int64_t>(&value)) {
    numbers.push_back(static_cast<double>(*integer));
  } else if (const auto* real = std::get_if<double>(&value)) {
    numbers.push_back(*real);
  } else if (const auto* reals = std::get_if<std::vector<double>>(&value)) {
    numbers = *reals;
  }
  for (const double number : numbers) {
    if (!is_within(number, limits)) {
      refuse(stage, fmt::format("the default {} of '{}' is outside its own limits", number,
                                parameter.name));
    }
  }
  if (const auto* text = std::get_if<std::string>(&value);
      text && !limits.choices.empty() &&
      std::find(limits.choices.begin(), limits.choices.end(), *text) == limits.choices.end()) {
    refuse(stage, fmt::format("the default '{}' of '{}' is not one of its choices", *text,
                              parameter.name));
  }
}

void check_parameters(const StageInfo& stage) {
  std::set<std::string> names;
  for (const ParameterInfo& parameter : stage.parameters) {
    if (!is_snake_case(parameter.name)) {
      refuse(stage, fmt::format("the parameter '{}' is not named in snake_case", parameter.name));
    }
    if (!names.insert(parameter.name).second) {
      refuse(stage, fmt::format("two parameters are named '{}'", parameter.name));
    }
    const Limits& limits = parameter.limits;
    if (limits.least && limits.most && !(*limits.least <= *limits.most)) {
      refuse(stage, fmt::format("the limits of '{}' leave no value", parameter.name));
    }
    check_default(stage, parameter);
  }
}

void check_stage(const StageInfo& stage) {
  if (!is_stage_id(stage.id)) refuse(stage, "its id is not of the form family/name in snake_case");
  if (stage.inputs.empty() && stage.outputs.empty()) {
    refuse(stage, "it has no ports; describe() must call ports(), input() or output()");
  }
  check_ports(stage, stage.inputs, "input");
  check_ports(stage, stage.outputs, "output");
  check_parameters(stage);
  if (stage.map && stage.outputs.empty()) {
    refuse(stage, "describe() must call ports(), since it is a Map");
  }
  if (!stage.extensions.empty() &&
      (stage.outputs.size() != 1 || stage.outputs[0].type != "stope/Artefact@1")) {
    refuse(stage, "it writes files but its only output is not a stope/Artefact@1");
  }
}

}  // namespace

void check_manifest(const Manifest& manifest) {
  if (manifest.stages.empty()) {
    throw PluginRefused(PluginStatus::kInvalid,
                        "It offers no stage: list one after STAGES in stope_add_plugin().");
  }
  std::set<std::string> ids;
  for (const StageInfo& stage : manifest.stages) {
    check_stage(stage);
    if (!ids.insert(stage.id).second) {
      throw PluginRefused(
          PluginStatus::kInvalid,
          fmt::format("It offers the stage '{}' twice: give one of the two another id "
                      "in its STOPE_STAGE.",
                      stage.id));
    }
  }
}

}  // namespace stope
