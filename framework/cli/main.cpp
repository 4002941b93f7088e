#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <exception>

#include "framework/cli/arguments.hpp"
#include "framework/cli/byte_size.hpp"
#include "framework/cli/exit_code.hpp"

namespace {

void add_pipeline(CLI::App& command, stope::Arguments& arguments) {
  command.add_option("pipeline", arguments.pipeline, "The pipeline file")->required();
  command
      .add_option("--set", arguments.overrides,
                  "Overrides a parameter or variable: stage.param=value, "
                  "stage.use=family/name, vars.name=value")
      ->allow_extra_args(false);
}

void add_plugin_path(CLI::App& command, stope::Arguments& arguments) {
  command.add_option("--plugin-path", arguments.plugin_path, "A folder of plugins, searched first")
      ->allow_extra_args(false);
}

void add_plugins(CLI::App& command, stope::Arguments& arguments) {
  add_plugin_path(command, arguments);
  command.add_flag("--json", arguments.json, "Print for programs");
}

void add_run(CLI::App& command, stope::Arguments& arguments) {
  add_pipeline(command, arguments);
  add_plugins(command, arguments);
  command.add_option("--out", arguments.out,
                     "The run's folder (default: out/<name of the pipeline file>)");
  command
      .add_option("--threads", arguments.threads, "Workers for parallel work (default: all cores)")
      ->check(CLI::Range(1, 4096));
  command.add_option("--seed", arguments.seed, "Seed of everything random (default: 0)")
      ->check(CLI::NonNegativeNumber);
  command.add_flag("--quiet,-q", arguments.quiet, "Print warnings and errors only");
  command.add_option_function<std::string>(
      "--memory",
      [&arguments](const std::string& text) {
        const auto bytes = stope::parse_byte_size(text);
        if (!bytes)
          throw CLI::ValidationError("--memory",
                                     "'" + text + "' is not a size; write 2GiB or 500MB.");
        if (*bytes < stope::kLeastMemory)
          throw CLI::ValidationError("--memory",
                                     "'" + text + "' is too little; a run needs 64MiB or more.");
        arguments.memory = *bytes;
      },
      "Memory for the whole process, such as 2GiB (default: half of RAM, at least 64MiB)");
}

int dispatch(int argc, char** argv) {
  stope::Arguments arguments;
  arguments.command_line.assign(argv, argv + argc);

  CLI::App app(
      "Stope turns recordings of open-pit mines into maps, road graphs and drivable paths.");
  app.require_subcommand(1);
  app.set_version_flag("--version", STOPE_VERSION);
  int (*command)(const stope::Arguments&) = nullptr;
  const auto subcommand = [&](const char* name, const char* doc,
                              int (*function)(const stope::Arguments&)) {
    CLI::App* sub = app.add_subcommand(name, doc);
    sub->callback([&command, function] { command = function; });
    return sub;
  };

  add_run(*subcommand("run", "Run a pipeline", stope::run_command), arguments);

  CLI::App* check =
      subcommand("check", "Check a pipeline without running it", stope::check_command);
  add_pipeline(*check, arguments);
  add_plugins(*check, arguments);

  add_plugins(*subcommand("stages", "List the stages and the plugins they come from",
                          stope::stages_command),
              arguments);

  CLI::App* inspect =
      subcommand("inspect", "Show a stage's ports and parameters", stope::inspect_command);
  inspect->add_option("stage", arguments.stage, "family/name; all stages if left out");
  inspect->add_flag("--markdown", arguments.markdown, "Print as a section of a Markdown page");
  add_plugins(*inspect, arguments);

  add_plugins(*subcommand("schema", "Print the JSON Schema of pipeline files, for editors",
                          stope::schema_command),
              arguments);

  CLI::App* graph = subcommand("graph", "Draw a pipeline", stope::graph_command);
  add_pipeline(*graph, arguments);
  add_plugin_path(*graph, arguments);
  graph->add_option("--format", arguments.format, "dot, mermaid or svg")
      ->check(CLI::IsMember({"dot", "mermaid", "svg"}));

  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? stope::kDone : stope::kWrongArguments;
  }
  return command(arguments);
}

}  // namespace

int main(int argc, char** argv) {
  // A file-size limit then makes a write fail, which is told in a sentence, instead of ending the
  // process.
  std::signal(SIGXFSZ, SIG_IGN);
  try {
    return dispatch(argc, argv);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "stope: %s\n", error.what());
    return stope::kRunFailed;
  }
}
