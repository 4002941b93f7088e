#pragma once

#include <cstddef>
#include <string_view>

namespace stope {

/// The place after anchors and tags (`&name`, `!tag`) that precede a value which begins at `at`.
std::size_t skip_properties(std::string_view text, std::size_t at);

/// The place after the closing quote of the quoted scalar that begins at `at`, or npos if the text
/// ends before it.
std::size_t quoted_end(std::string_view text, std::size_t at);

}  // namespace stope
