#include "framework/compare/comparison_json.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "framework/cache/json_complaint.hpp"
#include "framework/compare/words.hpp"
#include "stope/error.hpp"

namespace stope {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kFormat = 1;

using namespace words;

template <class E, class Names>
E value_of(const Json& json, const Names& names) {
  const std::string text = json.get<std::string>();
  for (std::size_t i = 0; i < names.size(); ++i)
    if (text == names[i]) return static_cast<E>(i);
  throw Error(fmt::format("'{}' is none of the words that can stand there", text));
}

Json numbers(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double value : values) list.push_back(std::isfinite(value) ? Json(value) : Json());
  return list;
}

std::vector<double> read_numbers(const Json& json) {
  std::vector<double> values;
  for (const Json& value : json)
    values.push_back(value.is_null() ? std::numeric_limits<double>::quiet_NaN()
                                     : value.get<double>());
  return values;
}

template <class T, class F>
Json list_of(const std::vector<T>& values, F&& to_json) {
  Json list = Json::array();
  for (const T& value : values) list.push_back(to_json(value));
  return list;
}

template <class F>
auto read_list(const Json& json, F&& read) {
  std::vector<decltype(read(json))> values;
  for (const Json& value : json) values.push_back(read(value));
  return values;
}

Json arm_json(const ComparedArm& arm) {
  return {{"name", arm.name},
          {"overrides", arm.overrides},
          {"plan", arm.plan},
          {"same_as", arm.same_as}};
}

ComparedArm read_arm(const Json& json) {
  return {json.at("name"), json.at("overrides"), json.at("plan"), json.at("same_as")};
}

Json recording_json(const ComparedRecording& recording) {
  return {
      {"name", recording.name}, {"overrides", recording.overrides}, {"same_as", recording.same_as}};
}

ComparedRecording read_recording(const Json& json) {
  return {json.at("name"), json.at("overrides"), json.value("same_as", "")};
}

Json metric_json(const ComparedMetric& metric) {
  return {{"name", metric.name},
          {"from", metric.stage},
          {"measure", metric.measure},
          {"better", word_for(metric.direction, kDirections)},
          {"matters", metric.smallest_that_matters},
          {"unit", metric.unit}};
}

ComparedMetric read_metric(const Json& json) {
  return {json.at("name"),    json.at("from"),
          json.at("measure"), value_of<Direction>(json.at("better"), kDirections),
          json.at("matters"), json.at("unit")};
}

Json stage_json(const CellStage& stage) {
  return {{"name", stage.name},
          {"use", stage.use},
          {"fate", word_for(stage.fate, kFates)},
          {"seconds", stage.seconds < 0 ? Json() : Json(stage.seconds)},
          {"items", stage.items}};
}

CellStage read_stage(const Json& json) {
  return {json.at("name"), json.at("use"), value_of<StageFate>(json.at("fate"), kFates),
          json.at("seconds").is_null() ? -1 : json.at("seconds").get<double>(), json.at("items")};
}

Json artefact_json(const CellArtefact& artefact) {
  return {{"output", artefact.output},
          {"path", artefact.path},
          {"sha256", artefact.sha256},
          {"bytes", artefact.bytes},
          {"kind", word_for(artefact.kind, kKinds)},
          {"companion", artefact.companion}};
}

CellArtefact read_artefact(const Json& json) {
  return {json.at("output"),
          json.at("path"),
          json.at("sha256"),
          json.at("bytes"),
          value_of<CellArtefact::Kind>(json.at("kind"), kKinds),
          json.at("companion")};
}

// Cells name their arm and so on in words, for those who read the file with a program of theirs.
Json cell_json(const Comparison& comparison, const ComparedCell& cell) {
  Json json{{"arm", comparison.arms[cell.arm].name},
            {"recording", comparison.recordings[cell.recording].name},
            {"seed", cell.run_seed},
            {"status", word_for(cell.status, kStatuses)}};
  if (!cell.sentence.empty()) json["sentence"] = cell.sentence;
  if (!cell.failed_stage.empty()) json["failed_stage"] = cell.failed_stage;
  json["key"] = cell.key;
  json["folder"] = cell.folder;
  json["measures"] = numbers(cell.measures);
  json["artefacts"] = list_of(cell.artefacts, artefact_json);
  json["stages"] = list_of(cell.stages, stage_json);
  return json;
}

void read_cell(const Json& json, ComparedCell& cell) {
  cell.run_seed = json.at("seed");
  cell.status = value_of<CellStatus>(json.at("status"), kStatuses);
  cell.sentence = json.value("sentence", "");
  cell.failed_stage = json.value("failed_stage", "");
  cell.key = json.at("key");
  cell.folder = json.at("folder");
  cell.measures = read_numbers(json.at("measures"));
  cell.artefacts = read_list(json.at("artefacts"), read_artefact);
  cell.stages = read_list(json.at("stages"), read_stage);
}

Json exclusion_json(const Exclusion& exclusion) {
  return {{"arm", exclusion.arm},
          {"recording", exclusion.recording},
          {"seed", exclusion.seed},
          {"metric", exclusion.metric},
          {"sentence", exclusion.sentence}};
}

Exclusion read_exclusion(const Json& json) {
  return {json.at("arm"), json.at("recording"), json.at("seed"), json.at("metric"),
          json.at("sentence")};
}

Json timing_json(const TimedPair& timed) {
  return {{"arm", timed.arm},
          {"recording", timed.recording},
          {"seed", timed.seed},
          {"baseline_seconds", numbers(timed.baseline_seconds)},
          {"arm_seconds", numbers(timed.arm_seconds)},
          {"key", timed.key}};
}

TimedPair read_timing(const Json& json) {
  return {json.at("arm"),
          json.at("recording"),
          json.at("seed"),
          read_numbers(json.at("baseline_seconds")),
          read_numbers(json.at("arm_seconds")),
          json.value("key", "")};
}

Comparison read(const Json& json) {
  if (json.at("format") != kFormat)
    throw Error(fmt::format("it has format {}, and this Stope reads {}", json.at("format").dump(),
                            kFormat));
  Comparison comparison;
  comparison.name = json.at("name");
  comparison.file = json.at("file").get<std::string>();
  comparison.base = json.at("base").get<std::string>();
  comparison.id = json.at("id");
  comparison.version = json.at("stope");
  comparison.started = json.at("started");
  comparison.ended = json.at("ended");
  comparison.threads = json.at("threads");
  comparison.complete = json.at("complete");
  // Not there in those of earlier Stopes.
  if (json.contains("set")) comparison.set = json.at("set").get<std::vector<std::string>>();
  comparison.arms = read_list(json.at("arms"), read_arm);
  comparison.recordings = read_list(json.at("recordings"), read_recording);
  comparison.seeds = json.at("seeds").get<std::vector<std::uint64_t>>();
  comparison.metrics = read_list(json.at("metrics"), read_metric);
  for (const ComparedArm& arm : comparison.arms) {
    if (arm.name == json.at("baseline")) break;
    ++comparison.baseline;
  }
  const Json& cells = json.at("cells");
  comparison.cells = empty_cells(comparison);
  if (cells.size() != comparison.cells.size() || comparison.baseline >= comparison.arms.size())
    throw Error("its table does not have the size that its lists ask for");
  for (std::size_t i = 0; i < cells.size(); ++i) read_cell(cells[i], comparison.cells[i]);
  comparison.exclusions = read_list(json.at("exclusions"), read_exclusion);
  comparison.timings = read_list(json.at("timings"), read_timing);
  comparison.warnings = json.at("warnings").get<std::vector<std::string>>();
  return comparison;
}

}  // namespace

std::string comparison_json(const Comparison& comparison) {
  Json json{{"format", kFormat},
            {"stope", comparison.version},
            {"name", comparison.name},
            {"file", comparison.file.string()},
            {"base", comparison.base.string()},
            {"id", comparison.id},
            {"started", comparison.started},
            {"ended", comparison.ended},
            {"threads", comparison.threads},
            {"complete", comparison.complete},
            {"baseline", comparison.arms[comparison.baseline].name}};
  json["set"] = comparison.set;
  json["arms"] = list_of(comparison.arms, arm_json);
  json["recordings"] = list_of(comparison.recordings, recording_json);
  json["seeds"] = comparison.seeds;
  json["metrics"] = list_of(comparison.metrics, metric_json);
  json["exclusions"] = list_of(comparison.exclusions, exclusion_json);
  json["warnings"] = comparison.warnings;
  json["timings"] = list_of(comparison.timings, timing_json);
  json["cells"] = list_of(comparison.cells,
                          [&](const ComparedCell& cell) { return cell_json(comparison, cell); });
  // Names in a file need not be UTF-8; a file that shows a replacement beats none.
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Comparison read_comparison_json(std::string_view text) {
  try {
    return read(Json::parse(text));
  } catch (const nlohmann::json::exception& error) {
    throw Error(json_complaint(error));
  }
}

}  // namespace stope
