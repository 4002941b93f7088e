#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace stope::source {

/// The files of a folder with an extension (".bin"), in the order of their names, where a run of
/// digits counts as a number (scan2 before scan10). Throws Error if the folder cannot be read or
/// holds none.
std::vector<std::filesystem::path> list_scan_files(const std::filesystem::path& folder,
                                                   const std::string& extension);

/// The part of `count` items a user asked for.
struct ItemRange {
  std::size_t first = 0, end = 0;
};

/// From `first` to `last` (both counted from 0 and included; `last` -1: to the end), at most
/// `limit` (0: no limit). Throws Error if nothing is left.
ItemRange choose_items(std::size_t count, std::int64_t first, std::int64_t last,
                       std::int64_t limit);

}  // namespace stope::source
