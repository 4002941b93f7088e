#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

namespace stope::report {

/// The SHA-256 of `bytes`, as 64 hexadecimal digits, as sha256sum prints it.
std::string sha256_of(std::span<const std::uint8_t> bytes);

/// The SHA-256 of a file, or nothing if it cannot be read.
std::optional<std::string> sha256_of_file(const std::filesystem::path& file);

}  // namespace stope::report
