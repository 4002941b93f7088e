#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "stope/abi_note.hpp"
#include "stope/stage_instance.hpp"

namespace stope {

/// What a plugin's one exported function returns.
struct PluginTable {
  std::uint32_t epoch;
  const char* id;
  const char* version;
  const StageEntry* const* stages;
  std::size_t stage_count;
};

using PluginEntry = const PluginTable* (*)();
inline constexpr const char* kPluginSymbol = "stope_plugin";

}  // namespace stope

/// Exports the plugin: its id, its version and its stages, given as calls of the functions
/// STOPE_STAGE defined. stope_add_plugin() generates the file that uses it.
#define STOPE_PLUGIN(id, version, ...)                                                      \
  extern "C" __attribute__((section(".note.stope"), used, aligned(4)))                      \
  const ::stope::AbiNote stope_abi_note = ::stope::make_abi_note(id, version);              \
  extern "C" STOPE_API const ::stope::PluginTable* stope_plugin() {                         \
    static const std::array stages{__VA_ARGS__};                                            \
    static const ::stope::PluginTable table{::stope::kAbiEpoch, id, version, stages.data(), \
                                            stages.size()};                                 \
    return &table;                                                                          \
  }
