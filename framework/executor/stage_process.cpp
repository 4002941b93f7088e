#include "framework/executor/stage_process.hpp"

#include <utility>

namespace stope {

StageProcess::StageProcess(const PlannedStage& stage, const RunServices& services,
                           std::unique_ptr<StageInstance> instance)
    : Process(stage.name, services),
      context_(*this, stage.seed_name(), services),
      instance_(std::move(instance)) {}

Outcome StageProcess::work() {
  for (std::size_t port = 0; port < inputs().size(); ++port) {
    InputEnd& input = *inputs()[port];
    instance_->connect_input(port, input.wired() ? &input : nullptr);
  }
  for (std::size_t port = 0; port < outputs().size(); ++port)
    instance_->connect_output(port, outputs()[port].get());
  return instance_->run(context_);
}

}  // namespace stope
