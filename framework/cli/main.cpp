#include <CLI/CLI.hpp>
#include <csignal>
#include <cstdio>
#include <exception>

#include "framework/cli/arguments.hpp"
#include "framework/cli/byte_size.hpp"
#include "framework/cli/exit_code.hpp"
#include "framework/cli/wrong_argument.hpp"

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

/// A size in bytes, such as 2GiB, of at least `least`.
void add_size(CLI::App& command, const char* name, std::size_t& bytes, std::size_t least,
              const std::string& too_little, const char* doc) {
  command.add_option_function<std::string>(
      name,
      [name, &bytes, least, too_little](const std::string& text) {
        const auto size = stope::parse_byte_size(text);
        if (!size)
          throw CLI::ValidationError(name, "'" + text + "' is not a size; write 2GiB or 500MB.");
        if (*size < least)
          throw CLI::ValidationError(name, "'" + text + "' is too little; " + too_little);
        bytes = *size;
      },
      doc);
}

void add_store(CLI::App& command, stope::Arguments& arguments) {
  command.add_option("--cache", arguments.cache,
                     "The store of results (default: $STOPE_CACHE, or stope/store in "
                     "$XDG_CACHE_HOME)");
}

void add_store_limit(CLI::App& command, stope::Arguments& arguments) {
  add_size(command, "--cache-limit", arguments.cache_limit, 1 << 20, "a store needs 1MiB or more.",
           "What the store may take on the disk (default: 20GiB); what was not used for longest "
           "goes first");
}

void add_threads_and_memory(CLI::App& command, stope::Arguments& arguments) {
  command
      .add_option("--threads", arguments.threads, "Workers for parallel work (default: all cores)")
      ->check(CLI::Range(1, 4096));
  add_size(command, "--memory", arguments.memory, stope::kLeastMemory, "a run needs 64MiB or more.",
           "Memory for the whole process, such as 2GiB (default: half of RAM, at least 64MiB)");
}

/// What a command that computes and leaves a folder has. `what` names it in the text of --out.
void add_work(CLI::App& command, stope::Arguments& arguments, const std::string& what) {
  add_plugins(command, arguments);
  command.add_option("--out", arguments.out, what);
  add_threads_and_memory(command, arguments);
  add_store(command, arguments);
  add_store_limit(command, arguments);
  command.add_flag("--quiet,-q", arguments.quiet, "Print warnings and errors only");
}

void add_run(CLI::App& command, stope::Arguments& arguments) {
  add_pipeline(command, arguments);
  add_work(command, arguments, "The run's folder (default: out/<name of the pipeline file>)");
  command.add_flag("--no-cache", arguments.no_cache, "Compute everything, keep nothing");
  command
      .add_option("--keep", arguments.keep,
                  "What the store keeps of the results: none, values (maps, graphs, measures, and "
                  "all outputs; the default) or all (streams as well)")
      ->check(CLI::IsMember({"none", "values", "all"}));
  command.add_flag("--why", arguments.why,
                   "Say of each stage that ran what has changed since the last run in this folder");
  command
      .add_flag("--resume", arguments.resume,
                "For long runs, from the first time on: keep all, so that a run that was "
                "killed goes on after the last stage that ended")
      ->excludes("--no-cache")
      ->excludes("--keep");
  command.add_option("--seed", arguments.seed, "Seed of everything random (default: 0)")
      ->check(CLI::NonNegativeNumber);
}

void add_compare(CLI::App& command, stope::Arguments& arguments) {
  command.add_option("experiment", arguments.pipeline, "The experiment file")->required();
  add_work(command, arguments,
           "The comparison's folder (default: out/<name of the experiment file>)");
  command.add_flag("--time-again", arguments.time_again,
                   "Take timings anew that an earlier run of the comparison took");
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

  add_compare(*subcommand("compare", "Compare variants of a pipeline, as an experiment file says",
                          stope::compare_command),
              arguments);

  CLI::App* replay = subcommand("replay", "Run a recorded run again and compare every artefact",
                                stope::replay_command);
  replay->add_option("record", arguments.record, "A run.json, or the folder of a run")->required();
  add_threads_and_memory(*replay, arguments);
  add_plugins(*replay, arguments);

  CLI::App* cache = app.add_subcommand("cache", "Look after the store of results");
  cache->require_subcommand(1);
  const auto cache_command = [&](const char* name, const char* doc,
                                 int (*function)(const stope::Arguments&)) {
    CLI::App* sub = cache->add_subcommand(name, doc);
    sub->callback([&command, function] { command = function; });
    add_store(*sub, arguments);
    sub->add_flag("--json", arguments.json, "Print for programs");
    return sub;
  };
  cache_command("ls", "List what is in the store", stope::cache_ls_command);
  add_store_limit(*cache_command("gc", "Remove what was not used for longest, down to the limit",
                                 stope::cache_gc_command),
                  arguments);
  cache_command("verify", "Read everything in the store and remove what is damaged",
                stope::cache_verify_command);

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
  } catch (const stope::WrongArgument& error) {
    std::fprintf(stderr, "stope: %s\n", error.what());
    return stope::kWrongArguments;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "stope: %s\n", error.what());
    return stope::kRunFailed;
  }
}
