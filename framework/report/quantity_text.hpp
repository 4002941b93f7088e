#pragma once

#include <cstdint>
#include <string>

/// Quantities as a person reads them: three significant digits and the unit that fits.
namespace stope::report {

/// `8.4 m`, `840 m`, `12.3 km`.
std::string length_text(double metres);
/// `1.24 s`, `312 ms`, `2 min 3 s`, `1 h 12 min`.
std::string duration_text(std::int64_t nanoseconds);
/// `312 B`, `1.24 MiB`.
std::string bytes_text(std::uint64_t bytes);
/// `4 216`, grouped by narrow spaces.
std::string count_text(std::uint64_t count);
/// `1 node`, `34 nodes`.
std::string count_text(std::uint64_t count, const char* singular, const char* plural);
/// Three significant digits, without trailing zeros or exponent where it can do without.
std::string number_text(double value);

}  // namespace stope::report
