#include "plugins/source/recording/pcd_scan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <limits>
#include <string>
#include <system_error>
#include <vector>

#include "plugins/source/recording/pcd_columns.hpp"
#include "stope/error.hpp"

namespace stope::source {
namespace {

const PcdField* first_of(const PcdHeader& header, std::initializer_list<const char*> names) {
  for (const char* name : names) {
    if (const PcdField* field = header.find(name)) return field;
  }
  return nullptr;
}

template <class T>
T clamped(double value) {
  if (!std::isfinite(value)) return 0;
  return static_cast<T>(std::clamp(value, static_cast<double>(std::numeric_limits<T>::lowest()),
                                   static_cast<double>(std::numeric_limits<T>::max())));
}

/// Nanoseconds before the last point. None if the times are not those of one sweep.
std::vector<std::int32_t> offsets_of(const std::vector<double>& times, double nanoseconds) {
  double last = -std::numeric_limits<double>::infinity();
  for (const double time : times) {
    if (!std::isfinite(time)) return {};
    last = std::max(last, time);
  }
  std::vector<std::int32_t> offsets;
  for (const double time : times) {
    const double offset = std::round((time - last) * nanoseconds);
    if (offset < std::numeric_limits<std::int32_t>::lowest()) return {};
    offsets.push_back(static_cast<std::int32_t>(offset));
  }
  return offsets;
}

std::string read_bytes(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw Error(fmt::format("cannot open {}: check that it exists", file.string()));
  return std::string(std::istreambuf_iterator<char>(stream), {});
}

}  // namespace

ReadScan parse_pcd_scan(std::string_view bytes) {
  const PcdHeader header = parse_pcd_header(bytes);
  if (header.points == 0) throw Error("it has no points: remove it or record it again");
  std::vector<const PcdField*> wanted;
  for (const char* name : {"x", "y", "z"}) {
    wanted.push_back(header.find(name));
    if (!wanted.back())
      throw Error(fmt::format("it has no field {}: a scan needs x, y and z", name));
  }
  const auto want = [&](const PcdField* field) {
    if (!field) return std::numeric_limits<std::size_t>::max();
    wanted.push_back(field);
    return wanted.size() - 1;
  };
  const std::size_t intensity = want(first_of(header, {"intensity", "i", "reflectivity"}));
  const std::size_t ring = want(first_of(header, {"ring", "channel", "laser_id"}));
  const PcdField* time_field = first_of(header, {"time", "t", "timestamp", "time_offset"});
  const std::size_t time = want(time_field);
  const std::size_t label = want(first_of(header, {"label"}));
  const auto columns = read_pcd_columns(header, bytes, wanted);

  ReadScan read;
  LidarScan& scan = read.scan;
  std::vector<double> times;
  for (std::size_t i = 0; i < header.points; ++i) {
    const Point3f point{static_cast<float>(columns[0][i]), static_cast<float>(columns[1][i]),
                        static_cast<float>(columns[2][i])};
    if (!std::isfinite(point.x) || !std::isfinite(point.y) || !std::isfinite(point.z)) {
      ++read.dropped;
      continue;
    }
    scan.points.push_back(point);
    if (intensity < columns.size()) scan.intensity.push_back(clamped<float>(columns[intensity][i]));
    if (ring < columns.size()) scan.ring.push_back(clamped<std::uint16_t>(columns[ring][i]));
    if (label < columns.size()) scan.label.push_back(clamped<std::uint8_t>(columns[label][i]));
    if (time < columns.size()) times.push_back(columns[time][i]);
  }
  if (scan.points.empty())
    throw Error(
        fmt::format("none of its {} points is finite (all are NaN or infinite): remove it "
                    "or record it again",
                    header.points));
  if (time_field) scan.time_offset = offsets_of(times, time_field->type == 'F' ? 1e9 : 1.0);
  return read;
}

ReadScan read_pcd_scan(const std::filesystem::path& file) {
  const std::string bytes = read_bytes(file);
  try {
    return parse_pcd_scan(bytes);
  } catch (const Error& error) {
    throw Error(fmt::format("cannot read the scan {}: {}", file.string(), error.what()));
  }
}

std::size_t pcd_scan_bytes(const std::filesystem::path& file) {
  std::error_code error;
  const auto size = std::filesystem::file_size(file, error);
  if (error) throw Error(fmt::format("cannot read {}: {}", file.string(), error.message()));
  if (size == 0)
    throw Error(fmt::format("the scan {} is empty: remove it or record it again", file.string()));
  return size;
}

}  // namespace stope::source
