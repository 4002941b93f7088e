#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "framework/plugins/catalogue.hpp"
#include "framework/plugins/manifest.hpp"

namespace stope {

/// Layout hashes of the SDK's payload types, by name, as this framework was built with them.
std::map<std::string, std::uint64_t> sdk_layouts();

/// Checks that the payloads of the SDK that a plugin's stages exchange have the layouts of
/// `layouts`. Throws PluginRefused, naming stage and type.
void check_layouts(const Manifest& manifest, const std::map<std::string, std::uint64_t>& layouts);

/// Whether one stage's output can be read by another's input, which both carry the same type: a
/// sentence that names both plugins if their layouts differ, else none.
std::optional<std::string> layout_mismatch(const StageRecord& producer, const PortInfo& output,
                                           const StageRecord& consumer, const PortInfo& input);

}  // namespace stope
