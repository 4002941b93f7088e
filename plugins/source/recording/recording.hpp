#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "plugins/source/recording/read_scan.hpp"
#include "plugins/source/recording/scan_files.hpp"
#include "stope/context.hpp"
#include "stope/payloads/trajectory.hpp"

namespace stope::source {

/// What recordings that are folders of scan files have in common: which files, when each was
/// scanned, and from where.
struct Recording {
  std::vector<std::filesystem::path> files;
  std::vector<Stamp> stamps;  ///< by file
  /// By file where poses come with the scans; any where a trajectory has times of its own; empty
  /// where nothing is known.
  Trajectory trajectory;
};

/// Where a recording's parts are.
struct RecordingFiles {
  std::filesystem::path scans;                      ///< folder
  std::string extension;                            ///< ".bin"
  std::optional<std::filesystem::path> poses;       ///< rows of 3x4, one a scan
  std::optional<std::filesystem::path> trajectory;  ///< TUM rows
  std::optional<std::filesystem::path> times;       ///< one a scan
  double rate = 10.0;                               ///< Hz, where no times are given
  std::int64_t first = 0, last = -1, limit = 0;     ///< as choose_items() has them
};

/// Lists and checks a recording without reading scans. A trajectory without a file of times must
/// have one row for each scan, and gives the scans their times. Throws Error if counts do not match
/// or a file cannot be understood.
Recording open_recording(const RecordingFiles& files);

/// Reads a scan file; says in the log which points were left out.
LidarScan load_scan(const std::filesystem::path& file,
                    ReadScan (*read)(const std::filesystem::path&), Context& context);

}  // namespace stope::source
