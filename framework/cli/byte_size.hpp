#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace stope {

/// The least a run may be given.
inline constexpr std::size_t kLeastMemory = std::size_t{64} << 20;

/// Bytes of a text such as `2GiB`, `512 MiB`, `1.5GB` or `1000000`; none if it is not a size.
std::optional<std::size_t> parse_byte_size(std::string_view text);

/// `1.5 GiB`, for people.
std::string byte_size_text(std::size_t bytes);

}  // namespace stope
