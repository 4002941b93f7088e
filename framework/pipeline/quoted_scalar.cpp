// yaml-cpp 0.7 accepts a quote that never closes if the file ends in a newline, and drops how a
// scalar was quoted. So the reader looks at the text again.
#include "framework/pipeline/quoted_scalar.hpp"

namespace stope {

std::size_t skip_properties(std::string_view text, std::size_t at) {
  while (at < text.size() && (text[at] == '&' || text[at] == '!')) {
    at = text.find_first_of(" \t\r\n", at);
    if (at == std::string_view::npos) return text.size();
    at = text.find_first_not_of(" \t\r\n", at);
    if (at == std::string_view::npos) return text.size();
  }
  return at;
}

std::size_t quoted_end(std::string_view text, std::size_t at) {
  const char quote = text[at];
  for (++at; at < text.size(); ++at) {
    if (quote == '"' && text[at] == '\\') {
      ++at;
    } else if (text[at] == quote) {
      if (quote == '"' || at + 1 >= text.size() || text[at + 1] != quote) return at + 1;
      ++at;  // '' inside single quotes is one quote
    }
  }
  return std::string_view::npos;
}

}  // namespace stope
