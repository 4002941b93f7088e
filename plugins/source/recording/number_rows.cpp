#include "plugins/source/recording/number_rows.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <fstream>
#include <string_view>

#include "stope/error.hpp"

namespace stope::source {
namespace {

constexpr std::size_t kShown = 40;  // characters of a bad word that a message repeats

std::string place(const std::filesystem::path& file, std::size_t line) {
  return fmt::format("{}:{}", file.string(), line);
}

/// Text as it may be printed: the control characters of a binary file opened by mistake stay out.
std::string printable(std::string_view word) {
  std::string text(word.substr(0, kShown));
  for (char& c : text) {
    if (c < ' ' || c > '~') c = '?';
  }
  return text;
}

}  // namespace

std::vector<NumberRow> read_number_rows(const std::filesystem::path& file, std::size_t count,
                                        const std::string& what) {
  std::ifstream stream(file);
  if (!stream) throw Error(fmt::format("cannot open {}: check that it exists", file.string()));
  std::vector<NumberRow> rows;
  std::string line;
  for (std::size_t number = 1; std::getline(stream, line); ++number) {
    NumberRow row{number, {}};
    std::string_view rest = line;
    while (true) {
      const std::size_t begin = rest.find_first_not_of(" \t\r,");
      if (begin == std::string_view::npos) break;
      if (row.values.empty() && rest[begin] == '#') break;
      rest.remove_prefix(begin);
      const std::string_view word = rest.substr(0, rest.find_first_of(" \t\r,"));
      rest.remove_prefix(word.size());
      const std::string_view digits = word[0] == '+' ? word.substr(1) : word;
      double value = 0;
      const auto [end, error] =
          std::from_chars(digits.data(), digits.data() + digits.size(), value);
      if (error != std::errc() || end != digits.data() + digits.size())
        throw Error(fmt::format("{}: \"{}\" is not a number; expected {}", place(file, number),
                                printable(word), what));
      if (!std::isfinite(value))
        throw Error(fmt::format("{}: \"{}\" is not finite; expected {}", place(file, number),
                                printable(word), what));
      row.values.push_back(value);
      if (row.values.size() > count) break;
    }
    if (row.values.empty()) continue;
    if (row.values.size() != count)
      throw Error(fmt::format("{}: the row has {} numbers; expected {}", place(file, number),
                              row.values.size() > count ? fmt::format("more than {}", count)
                                                        : std::to_string(row.values.size()),
                              what));
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace stope::source
