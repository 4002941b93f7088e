#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "framework/cli/arguments.hpp"
#include "framework/cli/exit_code.hpp"
#include "framework/cli/load_pipeline.hpp"
#include "framework/pipeline/plan_json.hpp"

namespace stope {

int check_command(const Arguments& arguments) {
  const LoadedPipeline loaded = load_pipeline(arguments);
  if (!loaded.plan) return loaded.exit_code;
  const Plan& plan = *loaded.plan;
  if (arguments.json) {
    nlohmann::json json = plan_json(plan);
    json["ok"] = true;
    fmt::print("{}\n", json.dump(2));
  } else {
    fmt::print("{} is right: {} stages, {} outputs.\n", arguments.pipeline.string(),
               plan.stages.size() - plan.outputs.size(), plan.outputs.size());
  }
  return kDone;
}

}  // namespace stope
