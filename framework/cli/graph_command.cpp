#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "framework/cli/arguments.hpp"
#include "framework/cli/exit_code.hpp"
#include "framework/cli/load_pipeline.hpp"
#include "framework/pipeline/schema.hpp"
#include "framework/report/graph/graph.hpp"

namespace stope {

int graph_command(const Arguments& arguments) {
  const LoadedPipeline loaded = load_pipeline(arguments);
  if (!loaded.plan) return loaded.exit_code;
  if (arguments.format == "mermaid") {
    fmt::print("{}", graph_mermaid(*loaded.plan));
  } else if (arguments.format == "svg") {
    fmt::print("{}", graph_svg(*loaded.plan));
  } else {
    fmt::print("{}", graph_dot(*loaded.plan));
  }
  return kDone;
}

int schema_command(const Arguments& arguments) {
  const auto catalogue = load_catalogue(arguments);
  fmt::print("{}\n", pipeline_schema(*catalogue).dump(2));
  return kDone;
}

}  // namespace stope
