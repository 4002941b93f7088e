#pragma once

#include <string>

#include "framework/pipeline/plan.hpp"

namespace stope::report {

/// `stage.port` of an output, the way pipelines write it.
inline std::string port_name(const Plan& plan, const PlannedSource& source) {
  const PlannedStage& stage = plan.stages[source.stage];
  return stage.name + "." + stage.info.outputs[source.port].name;
}

/// Whether an output carries a stream in this plan.
inline bool is_stream(const Plan& plan, const PlannedSource& source) {
  const PlannedStage& stage = plan.stages[source.stage];
  return source.port < stage.streams.size() && stage.streams[source.port];
}

}  // namespace stope::report
