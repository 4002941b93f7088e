#include "framework/executor/item_text.hpp"

#include <fmt/format.h>

namespace stope {

std::string time_text(Stamp stamp) {
  const bool negative = stamp < 0;
  const std::uint64_t size =
      negative ? ~static_cast<std::uint64_t>(stamp) + 1 : static_cast<std::uint64_t>(stamp);
  std::string text =
      fmt::format("{}{}.{:09}", negative ? "-" : "", size / 1'000'000'000, size % 1'000'000'000);
  const std::size_t least = text.find('.') + 4;
  while (text.size() > least && text.back() == '0') text.pop_back();
  return text + " s";
}

std::string item_text(std::uint64_t index, Stamp stamp) {
  return fmt::format("item {} ({})", index, time_text(stamp));
}

}  // namespace stope
