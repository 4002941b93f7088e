// Processor times of whole processes differ by a tenth from run to run on machines that others use,
// which is as much as is looked for. Which stages ran before and after is known exactly, and so is,
// from an undisturbed comparison, what each of them costs.
#include "tests/benchmarks/comparing/computed_twice.hpp"

#include <algorithm>
#include <functional>
#include <nlohmann/json.hpp>

#include "tests/benchmarks/comparing/measured_process.hpp"

namespace stope::benchmark {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

template <class Visit>
void for_each_run(const fs::path& comparison, Visit&& visit) {
  for (const auto& entry : fs::recursive_directory_iterator(comparison / "arms"))
    if (entry.path().filename() == "run.json") visit(entry.path());
}

/// The stages of a run that may have begun before it was killed, and ran after.
class BegunStages {
 public:
  BegunStages(const json& run, const std::set<std::string>& stored) : stored_(stored) {
    for (const json& stage : run.at("stages")) stages_[stage.at("name")] = &stage;
  }

  std::set<std::string> keys() const {
    std::set<std::string> found;
    for (const auto& [name, stage] : stages_)
      if (stage->at("from") == "run" && !is_stored(*stage) && may_have_begun(*stage))
        found.insert(key_of(*stage));
    return found;
  }

 private:
  static std::string key_of(const json& stage) { return stage.at("key").at("digest"); }
  bool is_stored(const json& stage) const { return stored_.contains(key_of(stage)); }

  bool may_have_begun(const json& stage) const {
    for (const auto& [port, source] : stage.at("inputs").items()) {
      if (!source.is_string()) continue;
      const std::string text = source;
      const std::size_t dot = text.rfind('.');
      const json& from = *stages_.at(text.substr(0, dot));
      if (is_stored(from)) continue;
      const bool stream = from.at("outputs").at(text.substr(dot + 1)).at("stream");
      if (!stream || !may_have_begun(from)) return false;
    }
    return true;
  }

  const std::set<std::string>& stored_;
  std::map<std::string, const json*> stages_;
};

}  // namespace

std::map<std::string, double> stage_seconds(const fs::path& comparison) {
  std::map<std::string, double> seconds;
  for_each_run(comparison, [&](const fs::path& file) {
    const json run = json::parse(text_of(file));
    std::map<std::string, double> of_process;
    for (const json& process : run.at("processes")) {
      const double work = process.at("work");
      of_process[process.at("name")] = work > 0 ? work : process.at("run").get<double>();
    }
    for (const json& stage : run.at("stages"))
      if (const auto found = of_process.find(stage.at("name")); found != of_process.end())
        seconds[stage.at("key").at("digest")] = found->second;
  });
  return seconds;
}

std::string unfinished_recording(const fs::path& comparison) {
  const fs::path file = comparison / "comparison.json";
  if (!fs::exists(file)) return "";
  const json before = json::parse(text_of(file));
  for (const json& recording : before.at("recordings"))
    for (const json& cell : before.at("cells"))
      if (cell.at("recording") == recording.at("name") && cell.at("status") == "pending")
        return recording.at("name");
  return "";
}

double most_computed_twice(const fs::path& comparison, const std::string& recording,
                           const std::set<std::string>& stored,
                           const std::map<std::string, double>& seconds) {
  std::set<std::string> twice;
  for_each_run(comparison, [&](const fs::path& file) {
    if (file.parent_path().parent_path().filename() != recording) return;
    const json run = json::parse(text_of(file));
    for (const std::string& key : BegunStages(run, stored).keys()) twice.insert(key);
  });
  double sum = 0;
  for (const std::string& key : twice) sum += seconds.at(key);
  return sum;
}

}  // namespace stope::benchmark
