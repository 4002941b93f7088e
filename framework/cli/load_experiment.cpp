#include "framework/cli/load_experiment.hpp"

#include <fstream>
#include <string>

#include "framework/cli/load_pipeline.hpp"

namespace stope {

LoadedExperiment load_experiment(const Arguments& arguments) {
  LoadedExperiment loaded;
  loaded.catalogue = load_catalogue(arguments);
  Diagnostics diagnostics;
  loaded.experiment = read_experiment(arguments.pipeline, diagnostics);
  if (loaded.experiment)
    loaded.plan = plan_experiment(*loaded.experiment, *loaded.catalogue, diagnostics);
  const std::vector<Diagnostic> list = diagnostics.sorted();
  if (loaded.plan) return loaded;
  print_diagnostics(list, arguments.json);
  loaded.exit_code = why_no_plan(list, *loaded.catalogue);
  return loaded;
}

bool is_experiment(const std::filesystem::path& file) {
  std::ifstream in(file);
  for (std::string line; std::getline(in, line);)
    if (line.starts_with("stope_experiment:")) return true;
  return false;
}

}  // namespace stope
