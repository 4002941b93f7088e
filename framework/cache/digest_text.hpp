#pragma once

#include <optional>
#include <string_view>

#include "stope/digest.hpp"

namespace stope {

/// The digest whose text() this is; none if it is no digest's.
std::optional<Digest> digest_of_hex(std::string_view text);

}  // namespace stope
