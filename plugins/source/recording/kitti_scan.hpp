#pragma once

#include <cstddef>
#include <filesystem>

#include "plugins/source/recording/read_scan.hpp"

namespace stope::source {

/// Checks, without reading it, that a file can be a KITTI scan: some points of 16 bytes. Returns
/// how many. Throws Error.
std::size_t count_kitti_points(const std::filesystem::path& file);

/// Reads a KITTI scan: float32 x, y, z, intensity for each point, little-endian. Throws Error if
/// the file is empty, is not a whole number of points, or has no finite point.
ReadScan read_kitti_scan(const std::filesystem::path& file);

}  // namespace stope::source
