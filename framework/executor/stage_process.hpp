#pragma once

#include <memory>

#include "framework/executor/process.hpp"
#include "framework/executor/stage_context.hpp"
#include "framework/pipeline/plan.hpp"

namespace stope {

/// A stage with a loop of its own, as a process.
class StageProcess final : public Process {
 public:
  StageProcess(const PlannedStage& stage, const RunServices& services,
               std::unique_ptr<StageInstance> instance);

 private:
  Outcome work() override;
  void release() override { instance_.reset(); }

  StageContext context_;
  std::unique_ptr<StageInstance> instance_;
};

}  // namespace stope
