#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "framework/cli/arguments.hpp"
#include "framework/cli/exit_code.hpp"
#include "framework/cli/load_pipeline.hpp"
#include "framework/cli/stage_text.hpp"

namespace stope {

int check_command(const Arguments& arguments) {
  const LoadedPipeline loaded = load_pipeline(arguments);
  if (!loaded.plan) return loaded.exit_code;
  const Plan& plan = *loaded.plan;
  if (!arguments.json) {
    fmt::print("{} is right: {} stages, {} outputs.\n", arguments.pipeline.string(),
               plan.stages.size() - plan.outputs.size(), plan.outputs.size());
    return kDone;
  }
  nlohmann::ordered_json json{{"ok", true}, {"name", plan.name}};
  for (const PlannedStage& stage : plan.stages) {
    nlohmann::ordered_json parameters = nlohmann::ordered_json::object();
    for (std::size_t i = 0; i < stage.parameters.size(); ++i) {
      parameters[stage.info.parameters[i].name] = value_text(stage.parameters[i]);
    }
    json["stages"].push_back({{"name", stage.name},
                              {"use", stage.info.id},
                              {"export", stage.is_export},
                              {"parameters", parameters}});
  }
  for (const PlannedOutput& output : plan.outputs) json["outputs"].push_back(output.name);
  fmt::print("{}\n", json.dump(2));
  return kDone;
}

}  // namespace stope
