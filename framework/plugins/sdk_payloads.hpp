#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "stope/payload.hpp"

namespace stope {

/// The payload types of the SDK as this Stope has them, in the order of their names.
const std::vector<const PayloadType*>& sdk_payloads();

/// The one of this name and layout; null if the SDK has none. What it decodes serves any plugin
/// that exchanges it: a plugin that lays it out otherwise is refused.
const PayloadType* sdk_payload(std::string_view name, std::uint64_t layout);

}  // namespace stope
