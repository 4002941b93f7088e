#include "framework/pipeline/sentence.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "framework/diagnostics/diagnostic.hpp"

namespace stope {

std::string quoted_list(const std::vector<std::string>& names, std::string_view last,
                        std::size_t most) {
  const std::size_t count = names.size() > most + 1 ? most : names.size();
  std::string text;
  for (std::size_t i = 0; i < count; ++i) {
    if (i > 0) {
      const bool at_end = i + 1 == names.size();
      text.append(at_end ? fmt::format(" {} ", last) : std::string(", "));
    }
    text.append("'").append(names[i]).append("'");
  }
  if (count < names.size()) text.append(fmt::format(" and {} more", names.size() - count));
  return text;
}

std::string did_you_mean(std::string_view name, const std::vector<std::string>& candidates,
                         std::string otherwise) {
  const std::string nearest = nearest_name(name, candidates);
  return nearest.empty() ? std::move(otherwise) : fmt::format("Did you mean '{}'?", nearest);
}

std::string joined(std::string first, std::string_view second) {
  if (!first.empty() && !second.empty()) first.append(" ");
  return first.append(second);
}

std::string shown(std::string_view text) {
  constexpr std::size_t kLongest = 80;
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const auto byte = static_cast<unsigned char>(text[i]);
    // Cut between characters, never inside one.
    if (result.size() >= kLongest && (byte & 0xC0U) != 0x80U) return result.append("…");
    if (byte < 0x20 || byte == 0x7f) {
      result.append(byte == '\n' ? std::string("\\n") : fmt::format("\\x{:02x}", byte));
    } else {
      result.push_back(text[i]);
    }
  }
  return result;
}

}  // namespace stope
