#pragma once

#include <string>

#include "framework/plugins/loaded_objects.hpp"

namespace stope {

/// The build id of the SDK's library in this process, hexadecimal; if it has none, a digest of its
/// file; empty if it has been removed.
std::string sdk_build_id();

/// Whether a library is the SDK's.
bool is_sdk(const LoadedObject& object);

}  // namespace stope
