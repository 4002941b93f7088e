#pragma once

#include <functional>
#include <string>
#include <utility>

#include "framework/executor/process.hpp"

namespace stope {

/// A reader that belongs to the framework, as a process with one input.
class SinkProcess final : public Process {
 public:
  SinkProcess(const Sink& sink, const RunServices& services)
      : Process(sink.name, services), sink_(sink) {
    inputs().push_back(std::make_unique<InputEnd>(*this));
  }

 private:
  Outcome work() override {
    return guarded([&] {
      while (const AnyItem item = inputs()[0]->next()) sink_.consume(item);
      if (sink_.finish) sink_.finish();
    });
  }

  const Sink& sink_;
};

}  // namespace stope
