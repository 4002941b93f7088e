#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace stope::exports {

/// Bytes of an artefact's text file.
inline std::vector<std::uint8_t> bytes_of(std::string_view text) {
  return {text.begin(), text.end()};
}

/// The shortest decimal that reads back as the same number, the same on every machine; `null` for
/// NaN and infinities, which JSON does not have.
std::string json_number(double value);

/// A JSON string with its quotes; control characters, quotes and backslashes escaped.
std::string json_text(std::string_view text);

}  // namespace stope::exports
