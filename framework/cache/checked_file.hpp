#pragma once

#include <filesystem>
#include <optional>

#include "stope/digest.hpp"
#include "stope/error.hpp"

namespace stope {

/// The bytes of a small file that ends in the digest of the rest; none if it is not there, was cut
/// off or has changed.
std::optional<std::vector<std::byte>> read_checked(const std::filesystem::path& file);

/// Writes such a file under a name of its own, then renames it. Throws Error with a sentence.
void write_checked(const std::filesystem::path& file, std::span<const std::byte> bytes);

/// A value that is kept in such a file; none if there is none that can be believed.
template <class T>
std::optional<T> load_checked(const std::filesystem::path& file) {
  const auto bytes = read_checked(file);
  if (!bytes) return std::nullopt;
  try {
    ByteReader reader(*bytes);
    T value;
    decode(value, reader);
    return value;
  } catch (const Error&) {
    return std::nullopt;  // of another version
  }
}

template <class T>
void save_checked(const std::filesystem::path& file, const T& value) {
  ByteBuffer buffer;
  encode(value, buffer);
  write_checked(file, buffer.bytes());
}

}  // namespace stope
