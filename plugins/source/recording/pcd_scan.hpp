#pragma once

#include <filesystem>
#include <string_view>

#include "plugins/source/recording/read_scan.hpp"

namespace stope::source {

/// Reads a scan from the bytes of a PCD file (ascii, binary, binary_compressed; PCL's file format).
/// Fields, of any numeric type: x, y, z; intensity; ring; time, t, timestamp or time_offset (whole
/// numbers are nanoseconds, others seconds, from any zero: offsets are taken from the last point);
/// label. Throws Error, which says what is wrong but not in which file.
ReadScan parse_pcd_scan(std::string_view bytes);

/// The same from a file. Throws Error that names it.
ReadScan read_pcd_scan(const std::filesystem::path& file);

/// What the scan of a PCD file will about take in memory, by the file's size. Throws Error if the
/// file cannot be read or is empty.
std::size_t pcd_scan_bytes(const std::filesystem::path& file);

}  // namespace stope::source
