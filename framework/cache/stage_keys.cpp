#include "framework/cache/stage_keys.hpp"

#include <fmt/format.h>

#include <map>
#include <variant>

#include "framework/cache/file_digests.hpp"
#include "stope/error.hpp"

namespace stope {
namespace {

constexpr const char* kLibraries = "linked libraries";

/// Two values have the same text only if they are the same to the last bit.
std::string exact_text(const ParameterValue& value) {
  struct ToText {
    std::string operator()(std::monostate) const { return "not given"; }
    std::string operator()(bool b) const { return b ? "true" : "false"; }
    std::string operator()(std::int64_t i) const { return fmt::format("{}", i); }
    std::string operator()(double d) const { return fmt::format("{}", d); }
    std::string operator()(const std::string& s) const { return fmt::format("\"{}\"", s); }
    std::string operator()(const std::vector<double>& list) const {
      return fmt::format("[{}]", fmt::join(list, ", "));
    }
    std::string operator()(const std::vector<std::string>& list) const {
      std::string text = "[";
      // With its length before it no text can pass for two.
      for (const std::string& one : list) text += fmt::format("{}:\"{}\" ", one.size(), one);
      return text + "]";
    }
  };
  return std::visit(ToText{}, value);
}

class KeyMaker {
 public:
  KeyMaker(const Plan& plan, const Catalogue& catalogue, const KeyFacts& facts)
      : plan_(plan), catalogue_(catalogue), facts_(facts) {}

  std::vector<StageKey> make() {
    for (const PlannedStage& stage : plan_.stages) keys_.push_back(key_of(stage));
    return std::move(keys_);
  }

 private:
  StageKey key_of(const PlannedStage& stage) {
    const StageRecord* record = catalogue_.find(stage.info.id);
    if (!record) throw Error(fmt::format("no plugin offers {} any more", stage.info.id));
    StageKey key;
    const auto add = [&](std::string name, std::string value) {
      key.parts.push_back({std::move(name), std::move(value)});
    };
    add("use", stage.info.id);
    add("plugin build", record->build_id);
    add(kLibraries, record->libraries);
    add("SDK build", facts_.sdk);
    for (std::size_t i = 0; i < stage.parameters.size(); ++i) add_parameter(stage, i, key);
    if (stage.info.also_reads) add_further_files(stage, key);
    for (std::size_t i = 0; i < stage.inputs.size(); ++i) add_input(stage, i, key);
    for (const PortInfo& port : stage.info.outputs)
      add("payload of output " + port.name, fmt::format("{} {:016x}", port.type, port.layout));
    // Randomness comes from the run's seed and the stage's name.
    add("seed", fmt::format("{}", facts_.seed));
    add("name", stage.seed_name());
    key.only_this_run = key.only_this_run || !stage.info.deterministic || stage.info.live;
    if (key.only_this_run) add("run", facts_.run);
    Digester digester;
    for (const KeyPart& part : key.parts) {
      encode(part.name, digester);
      encode(part.value, digester);
    }
    key.digest = digester.digest();
    return key;
  }

  void add_input(const PlannedStage& stage, std::size_t input, StageKey& key) const {
    const PortInfo& port = stage.info.inputs[input];
    std::string value = "not wired";
    if (const auto& source = stage.inputs[input]) {
      const PlannedStage& writer = plan_.stages[source->stage];
      value = fmt::format("{} of {}, {}", writer.info.outputs[source->port].name,
                          keys_[source->stage].digest.text(),
                          writer.streams[source->port] ? "a stream" : "a value");
      key.only_this_run = key.only_this_run || keys_[source->stage].only_this_run;
    }
    key.parts.push_back({"input " + port.name, std::move(value)});
    key.parts.push_back(
        {"payload of input " + port.name, fmt::format("{} {:016x}", port.type, port.layout)});
  }

  void add_parameter(const PlannedStage& stage, std::size_t place, StageKey& key) const {
    const ParameterInfo& parameter = stage.info.parameters[place];
    const ParameterValue& value = stage.parameters[place];
    const auto* path = std::get_if<std::string>(&value);
    const bool is_path = parameter.kind == ParameterKind::kPath && path;
    key.parts.push_back(
        {"parameter " + parameter.name, is_path ? content_of(*path, key) : exact_text(value)});
  }

  void add_further_files(const PlannedStage& stage, StageKey& key) const {
    const std::unique_ptr<StageInstance> instance = catalogue_.create(stage.info.id);
    Outcome outcome;
    for (std::size_t i = 0; i < stage.parameters.size() && outcome; ++i)
      outcome = instance->set_parameter(i, stage.parameters[i]);
    std::vector<std::filesystem::path> paths;
    if (outcome) outcome = instance->also_reads(paths);
    if (!outcome) {
      // The run will meet the same and say so where it belongs.
      key.only_this_run = true;
      key.parts.push_back({"further files", outcome.sentence});
    }
    for (std::size_t i = 0; i < paths.size(); ++i)
      key.parts.push_back(
          {fmt::format("further file {}", i + 1),
           fmt::format("{}, {}", paths[i].filename().string(), content_of(paths[i], key))});
  }

  std::string content_of(const std::filesystem::path& path, StageKey& key) const {
    try {
      key.files.push_back(path);
      const Digest digest = facts_.digest_of_path(path);
      return digest == kNothingThere ? "nothing there" : "content " + digest.text();
    } catch (const Error& error) {
      key.only_this_run = true;
      return error.what();
    }
  }

  const Plan& plan_;
  const Catalogue& catalogue_;
  const KeyFacts& facts_;
  std::vector<StageKey> keys_;
};

}  // namespace

std::vector<StageKey> stage_keys(const Plan& plan, const Catalogue& catalogue,
                                 const KeyFacts& facts) {
  return KeyMaker(plan, catalogue, facts).make();
}

std::vector<std::string> differences(const StageKey& before, const StageKey& now) {
  std::map<std::string, std::string> old;
  for (const KeyPart& part : before.parts) old.emplace(part.name, part.value);
  std::vector<std::string> sentences;
  for (const KeyPart& part : now.parts) {
    const auto found = old.find(part.name);
    if (found == old.end()) {
      sentences.push_back(fmt::format("{} is new", part.name));
    } else if (part.name == kLibraries && found->second != part.value) {
      sentences.emplace_back("a library that its plugin is linked with has changed");
    } else if (found->second != part.value) {
      sentences.push_back(
          part.name.starts_with("input ")
              ? fmt::format("{} has changed", part.name)
              : fmt::format("{} was {}, is {}", part.name, found->second, part.value));
    }
    if (found != old.end()) old.erase(found);
  }
  for (const auto& [name, value] : old) sentences.push_back(fmt::format("{} is gone", name));
  return sentences;
}

}  // namespace stope
