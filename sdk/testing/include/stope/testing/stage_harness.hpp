#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "stope/stope.hpp"
#include "stope/testing/memory_context.hpp"
#include "stope/testing/memory_ports.hpp"

namespace stope::testing {

/// Drives one stage through what its plugin exports, as the framework does: parameters and ports by
/// name, exceptions as Error. Link stope_stages_<id>, then:
///
///     extern "C" const stope::StageEntry* stope_stage_Watershed();
///     const auto roads = StageHarness(stope_stage_Watershed())
///                            .set("min_clearance", 3.0).input("grid", grid).apply<RoadGraph>();
class StageHarness {
 public:
  explicit StageHarness(const StageEntry* entry) {
    check(entry->create(instance_));
    inputs_.resize(instance_->info().inputs.size());
  }

  StageHarness& set(const std::string& name, const ParameterValue& value) {
    const auto& parameters = instance_->info().parameters;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      if (parameters[i].name == name) return check(instance_->set_parameter(i, value)), *this;
    }
    throw Error("the stage has no parameter " + name);
  }

  /// Of a Map: the value to apply it to.
  template <class T>
  StageHarness& input(const std::string& name, T value) {
    inputs_[place(instance_->info().inputs, name)] = {
        0, 0, std::make_shared<MemoryPayload<T>>(std::make_shared<const T>(std::move(value)))};
    return *this;
  }
  /// What it gives at one of its outputs. May be called again with other inputs.
  template <class Output>
  Output apply(std::size_t output = 0) {
    std::vector<std::shared_ptr<const void>> outputs(instance_->info().outputs.size());
    check(instance_->apply(inputs_, *context_, outputs));
    return *static_cast<const Output*>(outputs.at(output).get());
  }

  /// Of a Stage: its ports.
  StageHarness& connect_input(const std::string& name, InputPort& port) {
    instance_->connect_input(place(instance_->info().inputs, name), &port);
    return *this;
  }
  StageHarness& connect_output(const std::string& name, OutputPort& port) {
    instance_->connect_output(place(instance_->info().outputs, name), &port);
    return *this;
  }
  void run() { check(instance_->run(*context_)); }

  /// The files it reads besides those its parameters name.
  std::vector<std::filesystem::path> also_reads() const {
    std::vector<std::filesystem::path> paths;
    check(instance_->also_reads(paths));
    return paths;
  }

  const StageInfo& info() const { return instance_->info(); }
  MemoryContext& context() { return *context_; }

 private:
  static void check(const Outcome& outcome) {
    if (outcome.kind == Outcome::Kind::kCancelled) throw Cancelled();
    if (!outcome) throw Error(outcome.sentence);
  }
  static std::size_t place(const std::vector<PortInfo>& ports, const std::string& name) {
    for (std::size_t i = 0; i < ports.size(); ++i) {
      if (ports[i].name == name) return i;
    }
    throw Error("the stage has no port " + name);
  }

  std::unique_ptr<MemoryContext> context_ = std::make_unique<MemoryContext>();
  std::unique_ptr<StageInstance> instance_;
  std::vector<AnyItem> inputs_;
};

/// The sentence of the Error that `work` throws; empty if it throws none.
template <class Work>
std::string error_of(Work&& work) {
  try {
    std::forward<Work>(work)();
  } catch (const Error& error) {
    return error.what();
  }
  return {};
}

}  // namespace stope::testing
