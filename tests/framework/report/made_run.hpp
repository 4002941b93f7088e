#pragma once

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "framework/executor/run.hpp"
#include "framework/report/run_facts.hpp"
#include "stope/payloads/artefact.hpp"
#include "stope/testing/memory_ports.hpp"

/// Plans, records and items made by hand, for tests of the report without pipeline or executor.
namespace stope::made {

/// A new folder under the system's temporary one, removed with this object.
class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "stope-report-XXXXXX").string();
    if (!::mkdtemp(name.data())) throw Error("cannot make the temporary folder " + name);
    path = name;
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
  Folder(const Folder&) = delete;
  std::filesystem::path path;
};

inline std::string text_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

inline void put_text(const std::filesystem::path& file, const std::string& text) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << text;
}

/// Names of all files below a folder, relative to it, in order.
inline std::vector<std::string> files_below(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    if (!entry.is_directory())
      names.push_back(std::filesystem::relative(entry.path(), folder).string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

/// An item whose payload is in memory.
template <class T>
AnyItem item(T value, std::uint64_t index = 0, Stamp stamp = 0) {
  return {stamp, index,
          std::make_shared<testing::MemoryPayload<T>>(std::make_shared<const T>(std::move(value)))};
}

inline std::vector<std::uint8_t> bytes_of(const std::string& text) {
  return {text.begin(), text.end()};
}

/// An artefact of text files, as (extension, content).
inline Artefact artefact(const std::vector<std::pair<std::string, std::string>>& files) {
  Artefact artefact;
  for (const auto& [extension, content] : files)
    artefact.files.push_back({extension, bytes_of(content)});
  return artefact;
}

inline PortInfo port(std::string name, std::string type) {
  PortInfo info;
  info.name = std::move(name);
  info.type = std::move(type);
  return info;
}

/// Builds plans stage by stage.
class PlanMaker {
 public:
  explicit PlanMaker(std::string name) { plan.name = std::move(name); }

  /// Adds a stage with one input for each wire and outputs given as (name, type, stream).
  struct Output {
    std::string name, type;
    bool stream = false;
  };
  struct Wire {
    std::string name;
    PlannedSource from;
  };
  std::size_t stage(const std::string& name, const std::string& use, const std::vector<Wire>& wires,
                    const std::vector<Output>& outputs) {
    PlannedStage stage;
    stage.name = name;
    stage.info.id = use;
    for (const Wire& wire : wires) {
      const PortInfo& from = plan.stages[wire.from.stage].info.outputs[wire.from.port];
      stage.info.inputs.push_back(port(wire.name, from.type));
      stage.inputs.emplace_back(wire.from);
    }
    for (const Output& output : outputs) {
      stage.info.outputs.push_back(port(output.name, output.type));
      stage.streams.push_back(output.stream);
    }
    plan.stages.push_back(std::move(stage));
    return plan.stages.size() - 1;
  }
  /// Adds an entry under `outputs:` and its export.
  void output(const std::string& name, PlannedSource from, bool stream = false) {
    const std::size_t place = stage("export " + name, "export/any", {{"payload", from}},
                                    {{"artefact", std::string(Artefact::kType), stream}});
    plan.stages[place].is_export = true;
    plan.outputs.push_back({name, place, stream, {}});
  }

  Plan plan;
};

/// Knows one record for every stage id.
class AnyCatalogue final : public Catalogue {
 public:
  AnyCatalogue() {
    record_.plugin_id = "made";
    record_.plugin_version = "1.2.3";
    record_.build_id = "0123456789abcdef";
    record_.file = "/plugins/made.so";
  }
  const std::vector<StageRecord>& stages() const override { return none_; }
  const StageRecord* find(std::string_view) const override { return &record_; }
  std::unique_ptr<StageInstance> create(std::string_view) const override { return nullptr; }

 private:
  std::vector<StageRecord> none_;
  StageRecord record_;
};

inline RunFacts facts() {
  RunFacts facts;
  facts.version = "0.1.0";
  facts.command = {"stope", "run", "quickstart.yaml", "--out", "a folder"};
  facts.threads = 2;
  facts.memory = std::size_t{2} << 30;
  facts.seed = 7;
  return facts;
}

inline RunRecord ended(RunRecord::End end, std::string sentence = "") {
  RunRecord record;
  record.end = end;
  record.sentence = std::move(sentence);
  record.wall = 1'500'000'000;
  return record;
}

/// The sink of this name.
inline Sink& sink(std::vector<Sink>& sinks, const std::string& name) {
  for (Sink& sink : sinks) {
    if (sink.name == name) return sink;
  }
  throw Error("there is no sink " + name);
}

}  // namespace stope::made
