#pragma once

#include <string>

namespace stope {

/// The build id of the SDK's library in this process, hexadecimal; if it has none, a digest of its
/// file; empty if it has been removed.
std::string sdk_build_id();

}  // namespace stope
