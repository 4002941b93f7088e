#include "framework/report/quantity_text.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>

namespace stope::report {

namespace {

// Three significant digits with all their zeros, so that columns of them line up.
std::string digits_text(double value) {
  const double size = std::abs(value);
  const int decimals = size >= 99.95 ? 0 : (size >= 9.995 ? 1 : 2);
  return size >= 0.9995 ? fmt::format("{:.{}f}", size, decimals) : fmt::format("{:.3g}", size);
}

}  // namespace

std::string number_text(double value) {
  if (!std::isfinite(value)) return std::isnan(value) ? "not known" : (value < 0 ? "−∞" : "∞");
  std::string text = digits_text(value);
  if (text.find('e') == std::string::npos && text.find('.') != std::string::npos) {
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
  }
  return value < 0 ? fmt::format("−{}", text) : text;
}

std::string length_text(double metres) {
  if (!std::isfinite(metres)) return number_text(metres);
  return std::abs(metres) >= 999.5 ? fmt::format("{} km", number_text(metres / 1000.0))
                                   : fmt::format("{} m", number_text(metres));
}

std::string duration_text(std::int64_t nanoseconds) {
  const double seconds = static_cast<double>(nanoseconds) * 1e-9;
  if (seconds < 1e-6) return fmt::format("{} ns", nanoseconds);
  if (seconds < 0.9995e-3) return fmt::format("{} µs", digits_text(seconds * 1e6));
  if (seconds < 0.9995) return fmt::format("{} ms", digits_text(seconds * 1e3));
  if (seconds < 99.95) return fmt::format("{} s", digits_text(seconds));
  const std::int64_t whole = std::llround(seconds);
  if (whole < 3600) return fmt::format("{} min {} s", whole / 60, whole % 60);
  return fmt::format("{} h {} min", whole / 3600, whole % 3600 / 60);
}

std::string bytes_text(std::uint64_t bytes) {
  constexpr std::array kUnits{"B", "KiB", "MiB", "GiB", "TiB"};
  double value = static_cast<double>(bytes);
  std::size_t unit = 0;
  while (value >= 1024.0 && unit + 1 < kUnits.size()) value /= 1024.0, ++unit;
  return unit == 0 ? fmt::format("{} B", bytes)
                   : fmt::format("{} {}", number_text(value), kUnits[unit]);
}

std::string count_text(std::uint64_t count) {
  std::string digits = std::to_string(count);
  for (std::size_t i = digits.size(); i > 3;) digits.insert(i -= 3, "\u202f");
  return digits;
}

std::string count_text(std::uint64_t count, const char* singular, const char* plural) {
  return fmt::format("{} {}", count_text(count), count == 1 ? singular : plural);
}

}  // namespace stope::report
