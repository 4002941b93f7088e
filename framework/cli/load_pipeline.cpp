#include "framework/cli/load_pipeline.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "framework/cli/exit_code.hpp"
#include "framework/pipeline/check.hpp"

namespace stope {
namespace {

nlohmann::ordered_json to_json(const Diagnostic& diagnostic) {
  constexpr const char* kSeverities[] = {"error", "warning", "note"};
  nlohmann::ordered_json json;
  json["severity"] = kSeverities[static_cast<int>(diagnostic.severity)];
  json["code"] = diagnostic.code;
  json["file"] = diagnostic.place.file;
  json["line"] = diagnostic.place.line;
  json["column"] = diagnostic.place.column;
  json["sentence"] = diagnostic.sentence;
  json["hint"] = diagnostic.hint;
  return json;
}

}  // namespace

void print_diagnostics(const std::vector<Diagnostic>& list, bool json) {
  if (!json) {
    for (const Diagnostic& diagnostic : list) fmt::print(stderr, "{}\n", to_text(diagnostic));
    return;
  }
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const Diagnostic& diagnostic : list) all.push_back(to_json(diagnostic));
  fmt::print("{}\n", nlohmann::ordered_json{{"ok", false}, {"diagnostics", all}}.dump(2));
}

int why_no_plan(const std::vector<Diagnostic>& list, const PluginCatalogue& catalogue) {
  const bool unusable =
      std::any_of(catalogue.files().begin(), catalogue.files().end(),
                  [](const PluginFile& file) { return file.status != PluginStatus::kUsable; });
  const bool only_missing_stages =
      std::all_of(list.begin(), list.end(), [](const Diagnostic& diagnostic) {
        return diagnostic.severity != Severity::kError || diagnostic.code == "P050";
      });
  return unusable && only_missing_stages ? kPluginUnusable : kWrongArguments;
}

std::unique_ptr<PluginCatalogue> load_catalogue(const Arguments& arguments) {
  auto catalogue = std::make_unique<PluginCatalogue>(default_plugin_options(arguments.plugin_path));
  for (const std::string& sentence : catalogue->warnings()) {
    fmt::print(stderr, "warning: {}\n", sentence);
  }
  for (const PluginFile& file : catalogue->files()) {
    if (file.status == PluginStatus::kUsable) continue;
    fmt::print(stderr, "warning: {}: {}\n", file.path.string(), file.sentence);
  }
  return catalogue;
}

LoadedPipeline load_pipeline(const Arguments& arguments) {
  LoadedPipeline loaded;
  loaded.catalogue = load_catalogue(arguments);
  Diagnostics diagnostics;
  loaded.plan =
      check_pipeline(arguments.pipeline, arguments.overrides, *loaded.catalogue, diagnostics);
  const std::vector<Diagnostic> list = diagnostics.sorted();
  if (diagnostics.has_errors()) loaded.plan.reset();
  if (!loaded.plan || !arguments.json) print_diagnostics(list, arguments.json);
  if (!loaded.plan) loaded.exit_code = why_no_plan(list, *loaded.catalogue);
  for (const Diagnostic& diagnostic : list) {
    if (diagnostic.severity == Severity::kWarning) loaded.warnings.push_back(diagnostic);
  }
  return loaded;
}

}  // namespace stope
