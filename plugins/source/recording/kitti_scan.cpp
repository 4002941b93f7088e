#include "plugins/source/recording/kitti_scan.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <fstream>
#include <system_error>
#include <vector>

#include "stope/error.hpp"

namespace stope::source {
namespace {

using Record = std::array<float, 4>;

}  // namespace

std::size_t count_kitti_points(const std::filesystem::path& file) {
  std::error_code error;
  const auto size = std::filesystem::file_size(file, error);
  if (error) throw Error(fmt::format("cannot read {}: {}", file.string(), error.message()));
  if (size == 0)
    throw Error(fmt::format("the scan {} is empty: remove it (and its pose) or record it again",
                            file.string()));
  if (size % sizeof(Record) != 0)
    throw Error(fmt::format(
        "the scan {} has {} bytes, which is not a whole number of points of 16 bytes (float32 x y "
        "z intensity): it is truncated or in another format",
        file.string(), size));
  return size / sizeof(Record);
}

ReadScan read_kitti_scan(const std::filesystem::path& file) {
  std::vector<Record> records(count_kitti_points(file));
  std::ifstream stream(file, std::ios::binary);
  if (!stream.read(reinterpret_cast<char*>(records.data()),
                   static_cast<std::streamsize>(records.size() * sizeof(Record))))
    throw Error(fmt::format("cannot read all of {}: it shrank or the disk failed", file.string()));
  ReadScan read;
  read.scan.points.reserve(records.size());
  read.scan.intensity.reserve(records.size());
  for (const Record& record : records) {
    if (!std::isfinite(record[0]) || !std::isfinite(record[1]) || !std::isfinite(record[2])) {
      ++read.dropped;
      continue;
    }
    read.scan.points.push_back({record[0], record[1], record[2]});
    read.scan.intensity.push_back(std::isfinite(record[3]) ? record[3] : 0.0f);
  }
  if (read.scan.points.empty())
    throw Error(
        fmt::format("none of the {} points of the scan {} is finite (all are NaN or "
                    "infinite): remove it (and its pose) or record it again",
                    records.size(), file.string()));
  return read;
}

}  // namespace stope::source
