#include "framework/pipeline/plan_json.hpp"

#include <cmath>

namespace stope {
namespace {

using nlohmann::json;

json number_json(double number) {
  if (std::isfinite(number)) return number;
  return number > 0 ? "inf" : "-inf";
}

json source_json(const Plan& plan, const PlannedSource& source) {
  const PlannedStage& stage = plan.stages.at(source.stage);
  return stage.name + "." + stage.info.outputs.at(source.port).name;
}

json stage_json(const Plan& plan, const PlannedStage& stage) {
  json result{{"name", stage.name}, {"use", stage.info.id}, {"at", to_text(stage.place)}};
  result["parameters"] = json::object();
  for (std::size_t i = 0; i < stage.parameters.size(); ++i) {
    const ParameterInfo& parameter = stage.info.parameters[i];
    json value{{"value", value_json(stage.parameters[i])}};
    if (!parameter.unit.empty()) value["unit"] = parameter.unit;
    result["parameters"][parameter.name] = std::move(value);
  }
  result["inputs"] = json::object();
  for (std::size_t i = 0; i < stage.inputs.size(); ++i)
    if (stage.inputs[i])
      result["inputs"][stage.info.inputs[i].name] = source_json(plan, *stage.inputs[i]);
  result["outputs"] = json::object();
  for (std::size_t i = 0; i < stage.streams.size(); ++i)
    result["outputs"][stage.info.outputs[i].name] = {{"type", stage.info.outputs[i].type},
                                                     {"stream", bool(stage.streams[i])}};
  return result;
}

}  // namespace

json value_json(const ParameterValue& value) {
  struct ToJson {
    json operator()(std::monostate) const { return nullptr; }
    json operator()(bool b) const { return b; }
    json operator()(std::int64_t i) const { return i; }
    json operator()(double d) const { return number_json(d); }
    json operator()(const std::string& s) const { return s; }
    json operator()(const std::vector<double>& list) const {
      json result = json::array();
      for (const double d : list) result.push_back(number_json(d));
      return result;
    }
    json operator()(const std::vector<std::string>& list) const { return list; }
  };
  return std::visit(ToJson{}, value);
}

json plan_json(const Plan& plan) {
  json result{{"name", plan.name}, {"file", plan.file.string()}, {"vars", plan.vars}};
  result["files_read"] = json::array();
  for (const auto& file : plan.files_read) result["files_read"].push_back(file.string());
  result["stages"] = json::array();
  for (const PlannedStage& stage : plan.stages) result["stages"].push_back(stage_json(plan, stage));
  result["outputs"] = json::array();
  for (const PlannedOutput& output : plan.outputs)
    result["outputs"].push_back({{"name", output.name},
                                 {"use", plan.stages.at(output.stage).info.id},
                                 {"stream", output.stream}});
  return result;
}

}  // namespace stope
