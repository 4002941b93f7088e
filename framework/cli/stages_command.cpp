#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "framework/cli/arguments.hpp"
#include "framework/cli/exit_code.hpp"
#include "framework/cli/load_pipeline.hpp"
#include "framework/cli/stage_text.hpp"
#include "framework/pipeline/members.hpp"

namespace stope {
namespace {

std::vector<std::string> others(const Catalogue& catalogue, const std::string& id) {
  auto members = interchangeable_members(catalogue, id);
  std::erase(members, id);
  return members;
}

nlohmann::ordered_json stage_json(const StageRecord& record, const Catalogue& catalogue) {
  const StageInfo& info = record.info;
  nlohmann::ordered_json json{{"id", info.id},
                              {"summary", info.summary},
                              {"plugin", record.plugin_id},
                              {"version", record.plugin_version},
                              {"file", record.file.string()},
                              {"map", info.map},
                              {"deterministic", info.deterministic}};
  const auto ports = [](const std::vector<PortInfo>& list) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const PortInfo& port : list) {
      all.push_back({{"name", port.name},
                     {"type", port.type},
                     {"stream", port.stream},
                     {"required", port.required}});
    }
    return all;
  };
  json["inputs"] = ports(info.inputs);
  json["outputs"] = ports(info.outputs);
  json["parameters"] = nlohmann::ordered_json::array();
  for (const ParameterInfo& parameter : info.parameters) {
    json["parameters"].push_back({{"name", parameter.name},
                                  {"default", value_text(parameter.default_value)},
                                  {"unit", parameter.unit},
                                  {"accepts", limits_text(parameter)},
                                  {"required", parameter.limits.required},
                                  {"doc", parameter.doc}});
  }
  json["interchangeable"] = others(catalogue, info.id);
  return json;
}

}  // namespace

int stages_command(const Arguments& arguments) {
  const auto catalogue = load_catalogue(arguments);
  bool unusable = false;
  for (const PluginFile& file : catalogue->files()) {
    unusable = unusable || file.status != PluginStatus::kUsable;
  }
  if (arguments.json) {
    nlohmann::ordered_json json{{"stages", nlohmann::ordered_json::array()},
                                {"files", nlohmann::ordered_json::array()}};
    for (const StageRecord& record : catalogue->stages())
      json["stages"].push_back(stage_json(record, *catalogue));
    for (const PluginFile& file : catalogue->files()) {
      json["files"].push_back({{"file", file.path.string()},
                               {"status", status_name(file.status)},
                               {"sentence", file.sentence}});
    }
    fmt::print("{}\n", json.dump(2));
    return kDone;
  }
  std::size_t width = 0;
  for (const StageRecord& record : catalogue->stages())
    width = std::max(width, record.info.id.size());
  for (const StageRecord& record : catalogue->stages()) {
    fmt::print("{:<{}}  {}\n", record.info.id, width, record.info.summary);
  }
  return unusable && catalogue->stages().empty() ? kPluginUnusable : kDone;
}

int inspect_command(const Arguments& arguments) {
  const auto catalogue = load_catalogue(arguments);
  std::vector<const StageRecord*> chosen;
  if (arguments.stage.empty()) {
    for (const StageRecord& record : catalogue->stages()) chosen.push_back(&record);
  } else if (const StageRecord* record = catalogue->find(arguments.stage)) {
    chosen.push_back(record);
  } else {
    std::vector<std::string> ids;
    for (const StageRecord& other : catalogue->stages()) ids.push_back(other.info.id);
    const std::string near = nearest_name(arguments.stage, ids);
    fmt::print(stderr, "There is no stage '{}'.{} `stope stages` lists all.\n", arguments.stage,
               near.empty() ? "" : " Did you mean '" + near + "'?");
    return kWrongArguments;
  }
  if (arguments.json) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const StageRecord* record : chosen) all.push_back(stage_json(*record, *catalogue));
    fmt::print("{}\n", (arguments.stage.empty() ? all : all.front()).dump(2));
    return kDone;
  }
  for (const StageRecord* record : chosen) {
    const auto members = others(*catalogue, record->info.id);
    fmt::print("{}\n", arguments.markdown ? stage_markdown(*record, members)
                                          : stage_text(*record, members));
  }
  return kDone;
}

}  // namespace stope
