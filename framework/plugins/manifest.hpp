#pragma once

#include <string>
#include <vector>

#include "framework/plugins/linked_libraries.hpp"
#include "stope/codec.hpp"
#include "stope/stage_info.hpp"

namespace stope {

/// Everything a plugin says about itself: what the probe finds out and the cache keeps, so that
/// stages can be listed and pipelines checked without opening the plugin.
struct Manifest {
  std::string plugin_id, plugin_version;
  std::vector<StageInfo> stages;              ///< as the plugin lists them
  std::vector<LinkedLibrary> libraries = {};  ///< that it was found linked with
};

/// Changes when the encoded form does.
inline constexpr std::uint32_t kManifestFormat = 3;

void encode_manifest(const Manifest& manifest, ByteSink& sink);

/// Reads what encode_manifest() wrote. Throws Error if the bytes cannot be right.
Manifest decode_manifest(ByteSource& source);

}  // namespace stope
