#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "framework/cli/arguments.hpp"
#include "framework/cli/exit_code.hpp"
#include "framework/cli/load_experiment.hpp"
#include "framework/cli/load_pipeline.hpp"
#include "framework/compare/remarks.hpp"
#include "framework/pipeline/plan_json.hpp"

namespace stope {

namespace {

int check_experiment(const Arguments& arguments) {
  const LoadedExperiment loaded = load_experiment(arguments);
  if (!loaded.plan) return loaded.exit_code;
  for (const std::string& warning : loaded.plan->warnings)
    fmt::print(stderr, "warning: {}\n", warning);
  const std::string too_few =
      expected_remark(comparable_recordings(*loaded.experiment, *loaded.plan),
                      loaded.experiment->arms.size(), loaded.experiment->metrics.size());
  if (!too_few.empty()) fmt::print(stderr, "warning: {}\n", too_few);
  const std::size_t arms = loaded.experiment->arms.size();
  const std::size_t recordings = loaded.experiment->recordings.size();
  if (arguments.json) {
    fmt::print("{}\n",
               nlohmann::json{{"ok", true}, {"arms", arms}, {"recordings", recordings}}.dump(2));
  } else {
    fmt::print("{} is right: {} arms, {} recordings.\n", arguments.pipeline.string(), arms,
               recordings);
  }
  return kDone;
}

}  // namespace

int check_command(const Arguments& arguments) {
  if (is_experiment(arguments.pipeline)) return check_experiment(arguments);
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
