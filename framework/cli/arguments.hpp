#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace stope {

/// What a person typed, for all commands; each reads what it needs.
struct Arguments {
  std::vector<std::string> command_line;  ///< as typed, for the record
  std::filesystem::path executable;
  std::filesystem::path pipeline;
  std::filesystem::path out;  ///< empty: out/<name of the pipeline file>
  int threads = 0;            ///< 0: as many as the machine has
  std::size_t memory = 0;     ///< bytes; 0: half of RAM
  std::uint64_t seed = 0;
  std::vector<std::string> overrides;  ///< of --set
  std::vector<std::filesystem::path> plugin_path;
  std::filesystem::path cache;  ///< the store; empty: STOPE_CACHE or the user's cache folder
  std::size_t cache_limit = 0;  ///< bytes; 0: the default
  std::string keep;             ///< none, values or all; empty: what the command thinks best
  bool no_cache = false;
  bool why = false;
  bool resume = false;
  bool time_again = false;       ///< of compare
  std::filesystem::path record;  ///< of replay: a run.json or its folder
  bool json = false;
  bool quiet = false;
  std::string stage;           ///< of inspect
  bool markdown = false;       ///< of inspect
  std::string format = "dot";  ///< of graph
};

/// The commands; each returns an ExitCode.
int run_command(const Arguments& arguments);
int check_command(const Arguments& arguments);
int stages_command(const Arguments& arguments);
int inspect_command(const Arguments& arguments);
int schema_command(const Arguments& arguments);
int graph_command(const Arguments& arguments);
int cache_ls_command(const Arguments& arguments);
int cache_gc_command(const Arguments& arguments);
int cache_verify_command(const Arguments& arguments);
int replay_command(const Arguments& arguments);
int compare_command(const Arguments& arguments);

}  // namespace stope
