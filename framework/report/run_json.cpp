#include "framework/report/run_json.hpp"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <variant>

#include "framework/report/diagnostic_text.hpp"
#include "framework/report/port_name.hpp"

namespace stope::report {
namespace {

using Json = nlohmann::ordered_json;

double seconds(std::int64_t nanoseconds) { return static_cast<double>(nanoseconds) * 1e-9; }

Json to_json(const ParameterValue& value) {
  return std::visit(
      [](const auto& held) -> Json {
        if constexpr (std::is_same_v<std::decay_t<decltype(held)>, std::monostate>) {
          return nullptr;
        } else {
          return held;
        }
      },
      value);
}

Json pipeline_json(const ReportData& data) {
  Json files = Json::array();
  for (const FileRead& file : data.files_read)
    files.push_back(
        {{"path", file.path}, {"sha256", file.sha256.empty() ? Json(nullptr) : Json(file.sha256)}});
  return {{"name", data.plan.name},
          {"file", data.plan.file.string()},
          {"files", files},
          {"vars", Json(data.plan.vars)},
          {"overrides", data.facts.overrides},
          {"working_folder", data.facts.working_folder.string()}};
}

const char* from_name(StageReuse::From from) {
  switch (from) {
    case StageReuse::From::kRun:
      return "run";
    case StageReuse::From::kReopened:
      return "reopened";
    case StageReuse::From::kStore:
      return "store";
    case StageReuse::From::kNotNeeded:
      return "not needed";
  }
  return "";
}

Json key_json(const StageReuse& reuse) {
  Json parts = Json::array();
  for (const auto& [name, value] : reuse.parts) parts.push_back({name, value});
  return {{"digest", reuse.key}, {"only_this_run", reuse.only_this_run}, {"parts", parts}};
}

Json stage_json(const ReportData& data, std::size_t place) {
  const PlannedStage& stage = data.plan.stages[place];
  Json parameters = Json::object(), units = Json::object(), inputs = Json::object(),
       outputs = Json::object();
  for (std::size_t i = 0; i < stage.info.parameters.size(); ++i) {
    const ParameterInfo& info = stage.info.parameters[i];
    parameters[info.name] =
        i < stage.parameters.size() ? to_json(stage.parameters[i]) : to_json(info.default_value);
    if (!info.unit.empty()) units[info.name] = info.unit;
  }
  for (std::size_t i = 0; i < stage.inputs.size(); ++i) {
    if (stage.inputs[i]) inputs[stage.info.inputs[i].name] = port_name(data.plan, *stage.inputs[i]);
  }
  for (std::size_t i = 0; i < stage.info.outputs.size(); ++i)
    outputs[stage.info.outputs[i].name] = {
        {"type", stage.info.outputs[i].type},
        {"stream", i < stage.streams.size() && static_cast<bool>(stage.streams[i])}};
  Json json{{"name", stage.name}, {"use", stage.info.id}};
  if (stage.is_export) json["export"] = true;
  if (!stage.info.deterministic) json["deterministic"] = false;
  json["inputs"] = inputs;
  json["outputs"] = outputs;
  json["parameters"] = parameters;
  json["units"] = units;
  if (const StageRecord* record = data.catalogue.find(stage.info.id))
    json["plugin"] = {{"id", record->plugin_id},
                      {"version", record->plugin_version},
                      {"build_id", record->build_id},
                      {"file", record->file.string()}};
  if (const StageReuse* reuse = data.reuse_of(place)) {
    json["from"] = from_name(reuse->from);
    json["key"] = key_json(*reuse);
  }
  return json;
}

Json run_part(const ReportData& data) {
  const RunRecord& record = data.record;
  Json json{{"end", end_name(record.end)}};
  if (!record.sentence.empty()) json["sentence"] = record.sentence;
  if (!record.failed_stage.empty()) json["failed_stage"] = record.failed_stage;
  json["start"] = utc_text(data.facts.start);
  json["wall_seconds"] = seconds(record.wall);
  json["threads"] = data.facts.threads;
  json["memory"] = data.facts.memory;
  json["seed"] = data.facts.seed;
  json["peak_resident"] = record.peak_resident;
  json["payloads"] = {{"loaded", record.payloads_loaded},
                      {"spilled", record.payloads_spilled},
                      {"evicted", record.payloads_evicted},
                      {"bytes_spilled", record.bytes_spilled}};
  return json;
}

Json made_of_json(const ReportData& data, const PlannedOutput& output) {
  Json list = Json::array();
  for (const PlannedSource& source : data.sources_of(output)) {
    Json json{{"port", port_name(data.plan, source)},
              {"type", data.plan.stages[source.stage].info.outputs[source.port].type}};
    const TapResult* tap = data.tap_at(source);
    if (tap && !tap->digest.empty()) json["digest"] = tap->digest;
    list.push_back(std::move(json));
  }
  return list;
}

Json outputs_json(const ReportData& data) {
  Json list = Json::array();
  for (const PlannedOutput& output : data.plan.outputs) {
    const Json made_of = made_of_json(data, output);
    for (const WrittenFile& file : data.outputs) {
      if (file.output != output.name) continue;
      Json json{{"name", file.output},
                {"path", file.path},
                {"bytes", file.bytes},
                {"sha256", file.sha256}};
      if (file.companion) json["companion"] = true;
      json["made_of"] = made_of;
      list.push_back(std::move(json));
    }
  }
  return list;
}

Json process_json(const ProcessRecord& process) {
  return {{"name", process.name},
          {"begin", seconds(process.begin)},
          {"end", seconds(process.end)},
          {"run", seconds(process.run)},
          {"wait_in", seconds(process.wait_in)},
          {"wait_out", seconds(process.wait_out)},
          {"io", seconds(process.io)},
          {"work", seconds(process.work)},
          {"items_read", process.items_read},
          {"items_written", process.items_written}};
}

Json warnings_json(const ReportData& data) {
  Json list = Json::array();
  for (const Diagnostic& diagnostic : data.facts.warnings)
    list.push_back(diagnostic_text(diagnostic));
  for (const LogLine& line : data.log.warnings())
    list.push_back(line.stage.empty() ? line.sentence : line.stage + ": " + line.sentence);
  return list;
}

}  // namespace

const char* end_name(RunRecord::End end) {
  switch (end) {
    case RunRecord::End::kDone:
      return "done";
    case RunRecord::End::kFailed:
      return "failed";
    case RunRecord::End::kCancelled:
      return "cancelled";
  }
  return "";
}

std::string utc_text(std::chrono::system_clock::time_point time) {
  const auto milliseconds =
      std::chrono::duration_cast<std::chrono::milliseconds>(time.time_since_epoch()).count();
  const std::time_t whole = static_cast<std::time_t>(milliseconds / 1000);
  return fmt::format("{:%Y-%m-%dT%H:%M:%S}.{:03}Z", fmt::gmtime(whole), milliseconds % 1000);
}

std::string run_json(const ReportData& data) {
  Json json{{"format", 1}, {"stope", data.facts.version}, {"command", data.facts.command}};
  json["run"] = run_part(data);
  json["pipeline"] = pipeline_json(data);
  json["outputs"] = outputs_json(data);
  if (!data.outputs_kept.empty()) json["outputs_kept_from_earlier"] = data.outputs_kept;
  json["warnings"] = warnings_json(data);
  json["warning_count"] = data.facts.warnings.size() + data.log.warning_count();
  Json stages = Json::array(), processes = Json::array(), channels = Json::array();
  for (std::size_t i = 0; i < data.plan.stages.size(); ++i) stages.push_back(stage_json(data, i));
  for (const ProcessRecord& process : data.record.processes)
    processes.push_back(process_json(process));
  for (const ChannelRecord& channel : data.record.channels)
    channels.push_back({{"from", channel.from},
                        {"to", channel.to},
                        {"items", channel.items},
                        {"capacity", channel.capacity},
                        {"growths", channel.growths}});
  json["stages"] = stages;
  json["processes"] = processes;
  json["channels"] = channels;
  json["machine"] = {{"host", data.machine.host},          {"processor", data.machine.processor},
                     {"cores", data.machine.cores},        {"memory", data.machine.memory},
                     {"system", data.machine.system},      {"features", data.machine.features},
                     {"libraries", data.machine.libraries}};
  // Names in a file need not be UTF-8; a report that shows a replacement beats one that fails.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace stope::report
