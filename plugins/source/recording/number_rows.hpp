#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace stope::source {

/// A line of numbers in a text file.
struct NumberRow {
  std::size_t line = 0;  ///< from 1
  std::vector<double> values;
};

/// Reads a text file of numbers separated by blanks, tabs or commas; empty lines and lines that
/// begin with # are left out. Every row must hold `count` finite numbers. Throws Error that names
/// file and line; `what` says what a row is ("a pose, 12 numbers of a 3x4 matrix").
std::vector<NumberRow> read_number_rows(const std::filesystem::path& file, std::size_t count,
                                        const std::string& what);

}  // namespace stope::source
