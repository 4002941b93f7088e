#include "plugins/export/text_bytes.hpp"

#include <fmt/format.h>

namespace stope::exports {

std::string json_number(double value) {
  return std::isfinite(value) ? fmt::format("{}", value) : "null";
}

std::string json_real(double value) {
  std::string text = fmt::format("{}", value);
  if (text.find_first_of(".e") == std::string::npos) text += ".0";
  return text;
}

std::string json_any(double value) {
  return std::isfinite(value) ? json_real(value) : fmt::format("\"{}\"", value);
}

std::string json_id(std::uint64_t id) {
  return id <= (1ULL << 53) ? fmt::format("{}", id) : fmt::format("\"{}\"", id);
}

std::string json_text(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      quoted.push_back('\\');
      quoted.push_back(c);
    } else if (static_cast<unsigned char>(c) < 0x20) {
      quoted += fmt::format("\\u{:04x}", static_cast<unsigned>(c));
    } else {
      quoted.push_back(c);
    }
  }
  quoted.push_back('"');
  return quoted;
}

}  // namespace stope::exports
