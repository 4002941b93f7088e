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

/// The same for a finite number, but always with a point or an exponent, so that readers that ask
/// for a float find one.
std::string json_real(double value);

/// The same for any number: NaN and infinities become the texts "nan", "inf" and "-inf".
std::string json_any(double value);

/// An id: a number, or a text of its digits beyond 2^53, where many readers of JSON would round it.
std::string json_id(std::uint64_t id);

/// A JSON string with its quotes; control characters, quotes and backslashes escaped.
std::string json_text(std::string_view text);

}  // namespace stope::exports
