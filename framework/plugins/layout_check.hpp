#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "framework/plugins/manifest.hpp"

namespace stope {

/// Layout hashes of the SDK's payload types, by name, as this framework was built with them.
std::map<std::string, std::uint64_t> sdk_layouts();

/// Checks that the payloads of the SDK that a plugin's stages exchange have the layouts of
/// `layouts`. Throws PluginRefused, naming stage and type.
void check_layouts(const Manifest& manifest, const std::map<std::string, std::uint64_t>& layouts);

}  // namespace stope
