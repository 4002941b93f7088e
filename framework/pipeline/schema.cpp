#include "framework/pipeline/schema.hpp"

#include <fmt/format.h>

#include "framework/pipeline/export_choice.hpp"
#include "framework/pipeline/parameter_text.hpp"
#include "framework/pipeline/plan_json.hpp"

namespace stope {
namespace {

using nlohmann::json;

const char* const kVariable = "\\$\\{[A-Za-z_][A-Za-z0-9_-]*\\}";
const char* const kQuantity = "^\\s*[+-]?(\\.?inf|[0-9]+\\.?[0-9]*|\\.[0-9]+)([eE][+-]?[0-9]+)?.*$";
const char* const kWire = "^[A-Za-z_][A-Za-z0-9_-]*(\\.[^.\\s]+)?$";

json with_variable(json schemas) {
  schemas.push_back({{"type", "string"}, {"pattern", kVariable}});
  return {{"anyOf", std::move(schemas)}};
}

json number_schema(const ParameterInfo& parameter, const char* type) {
  json number{{"type", type}};
  const Limits& limits = parameter.limits;
  if (limits.least) number[limits.least_excluded ? "exclusiveMinimum" : "minimum"] = *limits.least;
  if (limits.most) number[limits.most_excluded ? "exclusiveMaximum" : "maximum"] = *limits.most;
  return with_variable({number, {{"type", "string"}, {"pattern", kQuantity}}});
}

json text_schema(const ParameterInfo& parameter) {
  if (parameter.limits.choices.empty())
    return {{"type", json::array({"string", "number", "boolean"})}};
  return with_variable(json::array({{{"enum", parameter.limits.choices}}}));
}

json list_schema(const ParameterInfo& parameter, json items) {
  json list{{"type", "array"}, {"items", std::move(items)}};
  if (parameter.limits.count_least) list["minItems"] = *parameter.limits.count_least;
  if (parameter.limits.count_most) list["maxItems"] = *parameter.limits.count_most;
  return with_variable(json::array({list}));
}

json kind_schema(const ParameterInfo& parameter) {
  switch (parameter.kind) {
    case ParameterKind::kBool:
      return with_variable(json::array({{{"type", "boolean"}}}));
    case ParameterKind::kInteger:
      return number_schema(parameter, "integer");
    case ParameterKind::kReal:
      return number_schema(parameter, "number");
    case ParameterKind::kText:
      return text_schema(parameter);
    case ParameterKind::kPath:
      return {{"type", "string"}};
    case ParameterKind::kReals:
      return list_schema(parameter, number_schema(parameter, "number"));
    default:
      return list_schema(parameter, text_schema(parameter));
  }
}

json parameter_schema(const ParameterInfo& parameter) {
  json schema = kind_schema(parameter);
  if (parameter.optional) schema = {{"anyOf", json::array({schema, {{"type", "null"}}})}};
  std::string text = parameter.doc;
  if (!parameter.unit.empty())
    text.append(fmt::format("{}A bare number is in {}.", text.empty() ? "" : " ", parameter.unit));
  if (!parameter.limits.required && !parameter.optional) {
    text.append(fmt::format("{}Default: {}.", text.empty() ? "" : " ",
                            value_text(parameter.default_value, parameter.unit)));
    schema["default"] = value_json(parameter.default_value);
  }
  if (!text.empty()) schema["description"] = text;
  return schema;
}

json parameters_schema(const StageInfo& info) {
  json properties = json::object();
  for (const ParameterInfo& parameter : info.parameters)
    properties[parameter.name] = parameter_schema(parameter);
  return {{"type", json::array({"object", "null"})},
          {"properties", properties},
          {"patternProperties", {{"/", {{"type", json::array({"object", "null"})}}}}},
          {"additionalProperties", false}};
}

json inputs_schema(const StageInfo& info) {
  json properties = json::object();
  for (const PortInfo& input : info.inputs) {
    std::string text = fmt::format("{}, {}{}.{}{}", input.type,
                                   info.map       ? "values or a stream"
                                   : input.stream ? "a stream"
                                                  : "one value",
                                   input.required ? "" : ", may be left out",
                                   input.doc.empty() ? "" : " ", input.doc);
    properties[input.name] = {{"allOf", json::array({{{"$ref", "#/definitions/wire"}}})},
                              {"description", text}};
  }
  return {{"anyOf", json::array({{{"$ref", "#/definitions/wire"}},
                                 {{"type", "object"}, {"properties", properties}}})}};
}

// A stage, or an output's long form: what follows from `use` hangs on a condition each.
json body_schema(const Catalogue& catalogue, bool exports) {
  json choices = json::array(), conditions = json::array();
  for (const StageRecord& record : catalogue.stages()) {
    const StageInfo& info = record.info;
    if (is_export(info) != exports) continue;
    json choice{{"const", info.id}};
    if (!info.summary.empty()) choice["description"] = info.summary;
    choices.push_back(choice);
    conditions.push_back(
        {{"if", {{"properties", {{"use", {{"const", info.id}}}}}, {"required", {"use"}}}},
         {"then",
          {{"properties", {{"in", inputs_schema(info)}, {"params", parameters_schema(info)}}}}}});
  }
  json body{{"type", json::array({"object", "null"})},
            {"properties",
             {{"use", with_variable(choices)}, {"in", json::object()}, {"params", json::object()}}},
            {"additionalProperties", false}};
  if (!conditions.empty()) body["allOf"] = conditions;
  return body;
}

}  // namespace

json pipeline_schema(const Catalogue& catalogue) {
  const json texts{{"type", "array"}, {"items", {{"type", "string"}}}};
  json properties{{"stope", {{"const", 1}, {"description", "The version of the format."}}},
                  {"name", {{"type", "string"}, {"description", "What the pipeline is called."}}},
                  {"include",
                   {{"anyOf", json::array({{{"type", "string"}}, texts})},
                    {"description", "Files whose vars, stages and outputs this one builds on."}}},
                  {"vars",
                   {{"type", json::array({"object", "null"})},
                    {"description", "Values to be used as ${name}."}}},
                  {"stages",
                   {{"type", "object"},
                    {"propertyNames", {{"pattern", "^[A-Za-z_][A-Za-z0-9_-]*$"}}},
                    {"additionalProperties", {{"$ref", "#/definitions/stage"}}}}},
                  {"outputs",
                   {{"type", json::array({"object", "null"})},
                    {"additionalProperties",
                     {{"anyOf", json::array({{{"$ref", "#/definitions/wire"}},
                                             {{"$ref", "#/definitions/export"}}})}}}}}};
  return {{"$schema", "http://json-schema.org/draft-07/schema#"},
          {"title", "Stope pipeline"},
          {"type", "object"},
          {"properties", properties},
          {"additionalProperties", false},
          {"definitions",
           {{"wire",
             {{"type", "string"},
              {"anyOf", json::array({{{"pattern", kWire}}, {{"pattern", kVariable}}})},
              {"description", "A stage, or stage.port."}}},
            {"stage", body_schema(catalogue, false)},
            {"export", body_schema(catalogue, true)}}}};
}

}  // namespace stope
