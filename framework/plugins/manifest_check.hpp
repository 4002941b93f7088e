#pragma once

#include "framework/plugins/manifest.hpp"

namespace stope {

/// Checks that what a plugin declares can be: ids and names well formed and unique, defaults of the
/// declared kind and within their limits. Throws PluginRefused with a sentence that names the stage
/// and the part.
void check_manifest(const Manifest& manifest);

}  // namespace stope
