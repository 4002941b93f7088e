#pragma once

#include <string>
#include <string_view>

namespace stope::report {

/// Text for HTML and SVG, in elements and in quoted attributes: `& < > " '` escaped, control
/// characters and bytes that are not UTF-8 replaced.
std::string escaped(std::string_view text);

}  // namespace stope::report
