#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace stope::report {

/// Bytes in base64 (RFC 4648), for data: addresses.
std::string base64(std::span<const std::uint8_t> bytes);

}  // namespace stope::report
