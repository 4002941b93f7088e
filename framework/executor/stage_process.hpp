#pragma once

#include <memory>
#include <string>

#include "framework/executor/process.hpp"
#include "framework/executor/stage_context.hpp"

namespace stope {

/// A stage with a loop of its own, as a process.
class StageProcess final : public Process {
 public:
  StageProcess(std::string name, const RunServices& services,
               std::unique_ptr<StageInstance> instance);

 private:
  Outcome work() override;
  void release() override { instance_.reset(); }

  StageContext context_;
  std::unique_ptr<StageInstance> instance_;
};

}  // namespace stope
