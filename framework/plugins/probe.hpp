#pragma once

#include <chrono>
#include <filesystem>

#include "framework/plugins/manifest.hpp"

namespace stope {

/// Opens a plugin in a child process, has it describe its stages there, and gives what it said.
/// Whatever the plugin does to the process that opens it, it does to the child. Throws
/// PluginRefused if the child crashes, hangs for longer than `limit`, exits, or says why not.
Manifest probe_plugin(const std::filesystem::path& file, std::chrono::milliseconds limit);

}  // namespace stope
