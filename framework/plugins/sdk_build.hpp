#pragma once

#include <string>

namespace stope {

/// The build id of the SDK's library in this process, hexadecimal; empty if it has none.
std::string sdk_build_id();

}  // namespace stope
