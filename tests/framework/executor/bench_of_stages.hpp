#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "framework/executor/run.hpp"
#include "stope/stope.hpp"

/// What tests of the executor build pipelines with, without plugins or YAML.
namespace stope::toy {

/// A catalogue of stage classes compiled into the test.
class ToyCatalogue final : public Catalogue {
 public:
  template <class S>
  void add(const std::string& id) {
    StageInfo info = InstanceOf<S>(id).info();
    info.map = S::kMap;
    records_.push_back({std::move(info), {}, "toy", "1", ""});
    makers_[id] = [id] { return std::make_unique<InstanceOf<S>>(id); };
  }
  const std::vector<StageRecord>& stages() const override { return records_; }
  const StageRecord* find(std::string_view id) const override {
    for (const StageRecord& record : records_) {
      if (record.info.id == id) return &record;
    }
    return nullptr;
  }
  std::unique_ptr<StageInstance> create(std::string_view id) const override {
    return makers_.at(std::string(id))();
  }

 private:
  std::vector<StageRecord> records_;
  std::map<std::string, std::function<std::unique_ptr<StageInstance>()>> makers_;
};

/// Builds a plan stage by stage, in topological order, and keeps the catalogue for it.
class PlanBuilder {
 public:
  using Parameters = std::map<std::string, ParameterValue>;
  /// `stage.port` of each wired input.
  using Wires = std::map<std::string, std::string>;

  template <class S>
  PlanBuilder& stage(const std::string& name, const Wires& wires = {},
                     const Parameters& parameters = {}) {
    const std::string id = "toy/" + name;
    catalogue.add<S>(id);
    PlannedStage planned;
    planned.name = name;
    planned.info = catalogue.find(id)->info;
    for (const ParameterInfo& parameter : planned.info.parameters) {
      const auto given = parameters.find(parameter.name);
      planned.parameters.push_back(given == parameters.end() ? parameter.default_value
                                                             : given->second);
    }
    bool any_stream = false;
    for (const PortInfo& port : planned.info.inputs) {
      const auto wire = wires.find(port.name);
      planned.inputs.push_back(wire == wires.end() ? std::nullopt
                                                   : std::optional(source(wire->second)));
      if (planned.inputs.back())
        any_stream |=
            plan.stages[planned.inputs.back()->stage].streams[planned.inputs.back()->port];
    }
    for (const PortInfo& port : planned.info.outputs)
      planned.streams.push_back(planned.info.map ? any_stream : port.stream);
    plan.stages.push_back(std::move(planned));
    return *this;
  }

  PlannedSource source(const std::string& text) const {
    const std::size_t dot = text.find('.');
    for (std::size_t i = 0; i < plan.stages.size(); ++i) {
      if (plan.stages[i].name != text.substr(0, dot)) continue;
      const auto& outputs = plan.stages[i].info.outputs;
      for (std::size_t port = 0; port < outputs.size(); ++port) {
        if (outputs[port].name == text.substr(dot + 1)) return {i, port};
      }
    }
    throw std::invalid_argument("no such output: " + text);
  }

  /// Collects what a stage writes.
  template <class T>
  PlanBuilder& collect(const std::string& from, std::vector<T>& into) {
    return sink(from, [&into](const AnyItem& item) { into.push_back(*Item<T>(item)); });
  }
  PlanBuilder& sink(const std::string& from, std::function<void(const AnyItem&)> consume) {
    sinks.push_back({"sink of " + from, source(from), std::move(consume), {}});
    return *this;
  }

  RunRecord run() { return run_plan(plan, catalogue, sinks, options, log); }

  struct Log final : RunObserver {
    void log(LogLevel, const std::string& stage, const std::string& sentence) override {
      lines.push_back(stage + ": " + sentence);
    }
    std::vector<std::string> lines;
  } log;
  ToyCatalogue catalogue;
  Plan plan;
  std::vector<Sink> sinks;
  RunOptions options;
};

inline std::uint32_t growths(const RunRecord& record) {
  std::uint32_t sum = 0;
  for (const ChannelRecord& channel : record.channels) sum += channel.growths;
  return sum;
}

}  // namespace stope::toy
