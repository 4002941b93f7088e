#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace stope::source {

/// A column of a PCD file.
struct PcdField {
  std::string name;
  char type = 'F';         ///< F: floating point, I: signed, U: unsigned
  std::size_t size = 4;    ///< bytes of a number
  std::size_t count = 1;   ///< numbers a point
  std::size_t offset = 0;  ///< bytes of the fields before it, in a point
};

/// What the text at a PCD file's head says (PCL's file format, version 0.7 and older ones).
struct PcdHeader {
  enum class Data { kAscii, kBinary, kBinaryCompressed };
  std::vector<PcdField> fields;
  std::size_t points = 0;
  std::size_t stride = 0;  ///< bytes of a point
  Data data = Data::kAscii;
  std::size_t body = 0;  ///< bytes of the head: where the points begin

  /// The field of one number called `name` (in small letters), however the file writes it.
  const PcdField* find(std::string_view name) const;
};

/// Reads the head of `bytes`. Throws Error, which says what is wrong but not in which file.
PcdHeader parse_pcd_header(std::string_view bytes);

}  // namespace stope::source
