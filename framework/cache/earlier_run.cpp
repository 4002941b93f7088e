#include "framework/cache/earlier_run.hpp"

#include <fmt/format.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "framework/cache/digest_text.hpp"
#include "framework/cache/json_complaint.hpp"
#include "stope/error.hpp"

namespace stope {
namespace {

using Json = nlohmann::json;

StageKey key_of(const Json& json) {
  StageKey key;
  key.digest = digest_of_hex(json.at("digest").get<std::string>()).value_or(Digest{});
  key.only_this_run = json.at("only_this_run").get<bool>();
  for (const Json& part : json.at("parts"))
    key.parts.push_back({part.at(0).get<std::string>(), part.at(1).get<std::string>()});
  return key;
}

constexpr int kFormat = 1;

EarlierRun run_of(const Json& json) {
  if (const Json& format = json.at("format"); format != kFormat)
    throw Error(fmt::format("it has format {}, and this Stope reads {}", format.dump(), kFormat));
  EarlierRun run;
  run.version = json.at("stope").get<std::string>();
  run.end = json.at("run").at("end").get<std::string>();
  run.seed = json.at("run").at("seed").get<std::uint64_t>();
  const Json& pipeline = json.at("pipeline");
  run.pipeline = pipeline.at("file").get<std::string>();
  run.working_folder = pipeline.at("working_folder").get<std::string>();
  run.overrides = pipeline.at("overrides").get<std::vector<std::string>>();
  for (const Json& file : pipeline.at("files"))
    run.files.push_back(
        {file.at("path").get<std::string>(),
         file.at("sha256").is_null() ? std::string() : file.at("sha256").get<std::string>()});
  for (const Json& stage : json.at("stages")) {
    if (!stage.contains("key")) continue;
    run.stages[stage.at("name").get<std::string>()] = {stage.at("use").get<std::string>(),
                                                       key_of(stage.at("key"))};
  }
  for (const Json& output : json.at("outputs"))
    run.outputs.push_back(
        {output.at("name").get<std::string>(), output.at("path").get<std::string>(),
         output.at("bytes").get<std::uint64_t>(), output.at("sha256").get<std::string>()});
  const Json& machine = json.at("machine");
  run.features = machine.at("features").get<std::vector<std::string>>();
  run.libraries = machine.at("libraries").get<std::string>();
  return run;
}

}  // namespace

EarlierRun read_earlier_run(const std::filesystem::path& file) {
  std::ifstream stream(file);
  if (!stream)
    throw Error(fmt::format("cannot open {}: give the run.json of a run, or the folder it lies in",
                            file.string()));
  std::string complaint;
  try {
    return run_of(Json::parse(stream));
  } catch (const Json::exception& error) {
    complaint = json_complaint(error);
  } catch (const Error& error) {
    complaint = error.what();
  }
  throw Error(fmt::format(
      "{} cannot be used: {}. Give the run.json of a run as this Stope leaves it, or make the run "
      "anew",
      file.string(), complaint));
}

std::string why_it_runs(const std::string& name, const StageKey& key, const EarlierRun* earlier,
                        bool take) {
  if (!take) return "the store is not asked";
  if (!earlier) return "no earlier run in this folder to compare with";
  const auto found = earlier->stages.find(name);
  if (found == earlier->stages.end()) return "the last run in this folder had no such stage";
  if (key.only_this_run) {
    // Its key holds the run's name, which always differs.
    return "it, or a stage above it, may give other bytes each time";
  }
  const std::vector<std::string> changes = differences(found->second.key, key);
  if (changes.empty()) return "nothing has changed, but what is asked of it is not in the store";
  return fmt::format("{}", fmt::join(changes, "; "));
}

}  // namespace stope
