#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace stope {

/// Reads an environment variable; none if it is not set. Tests give their own.
using Environment = std::function<std::optional<std::string>(const std::string& name)>;

/// The process's own environment.
Environment process_environment();

/// Where to look for plugins.
struct PluginSearch {
  std::vector<std::filesystem::path> places;  ///< absolute, in order, each once; all exist
  std::vector<std::string> warnings;          ///< of places a person named that are not there
};

/// The places to search, in this order: those named on the command line, those in
/// STOPE_PLUGIN_PATH (a colon-separated list of absolute paths), the user's folder
/// (XDG_DATA_HOME/stope/plugins), and ../lib/stope/plugins beside the folder of `executable`, which
/// holds in the build folder and after installation. A place is a folder or a single library. The
/// current directory is never one of them unless it is named.
PluginSearch plugin_search(const std::vector<std::filesystem::path>& command_line,
                           const std::filesystem::path& executable,
                           const Environment& environment = process_environment());

/// The file of the running program.
std::filesystem::path running_executable();

/// The folder for manifests, XDG_CACHE_HOME/stope/manifests, or none if the environment names no
/// home. It need not exist.
std::optional<std::filesystem::path> manifest_folder(
    const Environment& environment = process_environment());

/// The files that may be plugins: in each place those that end in `.so`, by name; each file once,
/// however many ways lead to it. Does not look into subfolders.
std::vector<std::filesystem::path> plugin_candidates(PluginSearch& search);

}  // namespace stope
