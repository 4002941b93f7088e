#include "framework/cli/stage_text.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <limits>

namespace stope {
namespace {

std::string kind_text(const ParameterInfo& parameter) {
  switch (parameter.kind) {
    case ParameterKind::kBool:
      return "true or false";
    case ParameterKind::kInteger:
      return "integer";
    case ParameterKind::kReal:
      return "number";
    case ParameterKind::kText:
      return "text";
    case ParameterKind::kPath:
      return "path";
    case ParameterKind::kReals:
      return "list of numbers";
    case ParameterKind::kTexts:
      return "list of texts";
  }
  return "";
}

std::string default_text(const ParameterInfo& parameter) {
  if (parameter.limits.required) return "required";
  const std::string value = value_text(parameter.default_value);
  const bool has_unit = !parameter.unit.empty() && value != "none";
  return has_unit ? value + " " + parameter.unit : value;
}

std::string port_line(const PortInfo& port, const StageInfo& info) {
  const char* flow = info.map ? "stream or value" : (port.stream ? "stream" : "value");
  std::string line = fmt::format("  {:<16} {} ({}{})", port.name, port.type, flow,
                                 port.required ? "" : ", optional");
  return port.doc.empty() ? line : line + "  " + port.doc;
}

std::string port_row(const char* direction, const PortInfo& port, const StageInfo& info) {
  const char* flow = info.map ? "stream or value" : (port.stream ? "stream" : "value");
  return fmt::format("| {} `{}` | `{}` | {}{} | {} |\n", direction, port.name, port.type, flow,
                     port.required ? "" : ", optional", port.doc);
}

}  // namespace

std::string value_text(const ParameterValue& value) {
  struct Print {
    std::string operator()(std::monostate) const { return "none"; }
    std::string operator()(bool flag) const { return flag ? "true" : "false"; }
    std::string operator()(std::int64_t number) const { return std::to_string(number); }
    std::string operator()(double number) const { return fmt::format("{}", number); }
    std::string operator()(const std::string& text) const { return text.empty() ? "\"\"" : text; }
    std::string operator()(const std::vector<double>& list) const {
      return fmt::format("[{}]", fmt::join(list, ", "));
    }
    std::string operator()(const std::vector<std::string>& list) const {
      return fmt::format("[{}]", fmt::join(list, ", "));
    }
  };
  return std::visit(Print{}, value);
}

std::string limits_text(const ParameterInfo& parameter) {
  const Limits& limits = parameter.limits;
  std::vector<std::string> parts;
  // That a number must fit the machine's integers is no news to anyone.
  const bool least_is_news = limits.least && *limits.least > std::numeric_limits<int>::min();
  const bool most_is_news = limits.most && *limits.most < std::numeric_limits<int>::max();
  if (least_is_news)
    parts.push_back(fmt::format("{} {}", limits.least_excluded ? ">" : ">=", *limits.least));
  if (most_is_news)
    parts.push_back(fmt::format("{} {}", limits.most_excluded ? "<" : "<=", *limits.most));
  if (!limits.choices.empty())
    parts.push_back(fmt::format("one of {}", fmt::join(limits.choices, ", ")));
  if (limits.count_least && limits.count_least == limits.count_most) {
    parts.push_back(fmt::format("{} of them", *limits.count_least));
  } else if (limits.count_least || limits.count_most) {
    parts.push_back(fmt::format("{} to {} of them", limits.count_least.value_or(0),
                                limits.count_most.value_or(0)));
  }
  if (limits.path == PathKind::kFile) parts.emplace_back("an existing file");
  if (limits.path == PathKind::kFolder) parts.emplace_back("an existing folder");
  if (limits.path == PathKind::kFileOrFolder) parts.emplace_back("an existing file or folder");
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string stage_text(const StageRecord& record, const std::vector<std::string>& interchangeable) {
  const StageInfo& info = record.info;
  std::string text = fmt::format("{}\n  {}\n", info.id, info.summary);
  if (!info.source.empty()) text += fmt::format("  Source: {}\n", info.source);
  if (!info.notes.empty()) text += fmt::format("  Note: {}\n", info.notes);
  if (!info.deterministic) text += "  Not deterministic: its outputs are not reused.\n";
  text += "\nInputs\n";
  for (const PortInfo& port : info.inputs) text += port_line(port, info) + "\n";
  if (info.inputs.empty()) text += "  none\n";
  text += "\nOutputs\n";
  for (const PortInfo& port : info.outputs) text += port_line(port, info) + "\n";
  if (!info.extensions.empty())
    text += fmt::format("\nWrites files ending in: {}\n", fmt::join(info.extensions, ", "));
  text += "\nParameters\n";
  for (const ParameterInfo& parameter : info.parameters) {
    const std::string limits = limits_text(parameter);
    text += fmt::format("  {:<20} {} = {}{}\n      {}\n", parameter.name, kind_text(parameter),
                        default_text(parameter), limits.empty() ? "" : " (" + limits + ")",
                        parameter.doc);
  }
  if (info.parameters.empty()) text += "  none\n";
  if (!interchangeable.empty())
    text += fmt::format("\nCan be swapped with: {}\n", fmt::join(interchangeable, ", "));
  return text + fmt::format("\nFrom {} {} in {}\n", record.plugin_id, record.plugin_version,
                            record.file.string());
}

std::string stage_markdown(const StageRecord& record,
                           const std::vector<std::string>& interchangeable) {
  const StageInfo& info = record.info;
  std::string text = fmt::format("## {}\n{}\n", info.id, info.summary);
  if (!info.source.empty()) text += fmt::format("\nSource: {}\n", info.source);
  if (!info.notes.empty()) text += fmt::format("\nNote: {}\n", info.notes);
  text += "\n| port | type | | |\n|---|---|---|---|\n";
  for (const PortInfo& port : info.inputs) text += port_row("in", port, info);
  for (const PortInfo& port : info.outputs) text += port_row("out", port, info);
  if (!info.extensions.empty())
    text += fmt::format("\nWrites: {}\n", fmt::join(info.extensions, ", "));
  if (!info.parameters.empty())
    text += "\n| parameter | kind | default | accepts | |\n|---|---|---|---|---|\n";
  for (const ParameterInfo& parameter : info.parameters) {
    text += fmt::format("| `{}` | {} | {} | {} | {} |\n", parameter.name, kind_text(parameter),
                        default_text(parameter), limits_text(parameter), parameter.doc);
  }
  if (!interchangeable.empty())
    text += fmt::format("\nCan be swapped with: {}\n", fmt::join(interchangeable, ", "));
  return text;
}

}  // namespace stope
