#pragma once

#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "stope/stage_instance.hpp"
#include "stope/testing/memory_context.hpp"
#include "stope/testing/memory_ports.hpp"

namespace stope::source {

/// A source stage as the framework would use it, with outputs that keep what it writes.
class StageHarness {
 public:
  explicit StageHarness(const StageEntry* entry) {
    const Outcome made = entry->create(stage_);
    EXPECT_TRUE(made) << made.sentence;
  }

  StageHarness& set(const std::string& name, const ParameterValue& value) {
    const auto& parameters = stage_->info().parameters;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
      if (parameters[i].name != name) continue;
      EXPECT_TRUE(stage_->set_parameter(i, value)) << name;
      return *this;
    }
    ADD_FAILURE() << "there is no parameter " << name;
    return *this;
  }

  template <class T>
  StageHarness& keep(const std::string& name, testing::MemoryOutput<T>& output) {
    const auto& outputs = stage_->info().outputs;
    for (std::size_t i = 0; i < outputs.size(); ++i) {
      if (outputs[i].name == name) stage_->connect_output(i, &output);
    }
    return *this;
  }

  Outcome run() { return stage_->run(context); }

  testing::MemoryContext context;

 private:
  std::unique_ptr<StageInstance> stage_;
};

}  // namespace stope::source
