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

/// The stages that a run which was gone on with executed, and what the store had of them before.
class StagesRun {
 public:
  StagesRun(const json& run, const std::set<std::string>& stored) : stored_(stored) {
    for (const json& stage : run.at("stages")) stages_[stage.at("name")] = &stage;
  }

  /// Keys of those that may have begun before it was killed.
  std::set<std::string> begun() const {
    std::set<std::string> found;
    for (const auto& [name, stage] : stages_)
      if (ran(*stage) && may_have_begun(*stage)) found.insert(key_of(*stage));
    return found;
  }

  /// Keys of those that the store had whole. Streams are not kept: who gave one to a stage that had
  /// not ended must give it again.
  std::set<std::string> again() const {
    std::set<std::string> found;
    for (const auto& [name, stage] : stages_)
      if (ran(*stage) && is_stored(*stage)) found.insert(key_of(*stage));
    for (const auto& [name, reader] : stages_) {
      if (!ran(*reader)) continue;
      for_each_input(*reader, [&](const json& from, bool stream) {
        if (stream) found.erase(key_of(from));
        return true;
      });
    }
    return found;
  }

 private:
  static std::string key_of(const json& stage) { return stage.at("key").at("digest"); }
  static bool ran(const json& stage) { return stage.at("from") == "run"; }
  bool is_stored(const json& stage) const { return stored_.contains(key_of(stage)); }

  /// Until `visit` says false, which is what it gives then.
  template <class Visit>
  bool for_each_input(const json& stage, Visit&& visit) const {
    for (const auto& [port, source] : stage.at("inputs").items()) {
      if (!source.is_string()) continue;
      const std::string text = source;
      const std::size_t dot = text.rfind('.');
      const json& from = *stages_.at(text.substr(0, dot));
      if (!visit(from, from.at("outputs").at(text.substr(dot + 1)).at("stream").get<bool>()))
        return false;
    }
    return true;
  }

  bool may_have_begun(const json& stage) const {
    return for_each_input(stage, [&](const json& from, bool stream) {
      return is_stored(from) || (stream && may_have_begun(from));
    });
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
    for (const std::string& key : StagesRun(run, stored).begun()) twice.insert(key);
  });
  double sum = 0;
  for (const std::string& key : twice) sum += seconds.at(key);
  return sum;
}

std::size_t ran_again(const fs::path& comparison, const std::set<std::string>& stored,
                      fs::file_time_type since) {
  std::set<std::string> again;
  for_each_run(comparison, [&](const fs::path& file) {
    if (fs::last_write_time(file) < since) return;
    const json run = json::parse(text_of(file));
    again.merge(StagesRun(run, stored).again());
  });
  return again.size();
}

}  // namespace stope::benchmark
