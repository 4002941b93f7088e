#include "plugins/export/cloud_records.hpp"

#include <bit>
#include <cmath>
#include <cstring>

namespace stope::exports {
namespace {

static_assert(std::endian::native == std::endian::little, "clouds are written as they lie");

constexpr double kSingleReach = 8192;  // metres: beyond it a float is coarser than a millimetre

template <class T>
void put(std::uint8_t*& at, T value) {
  std::memcpy(at, &value, sizeof(value));
  at += sizeof(value);
}

}  // namespace

CloudRecords records_of(const PointCloud& cloud) {
  bool wide = false;
  for (const Point3f& point : cloud.points) {
    wide = wide || std::abs(cloud.origin.x() + point.x) > kSingleReach ||
           std::abs(cloud.origin.y() + point.y) > kSingleReach ||
           std::abs(cloud.origin.z() + point.z) > kSingleReach;
  }
  const int coordinate = wide ? 8 : 4;
  const bool with_intensity = !cloud.intensity.empty(), with_label = !cloud.label.empty();
  CloudRecords records;
  for (const char* axis : {"x", "y", "z"}) records.fields.push_back({axis, 'F', coordinate});
  if (with_intensity) records.fields.push_back({"intensity", 'F', 4});
  if (with_label) records.fields.push_back({"label", 'U', 1});
  std::size_t stride = 0;
  for (const CloudField& field : records.fields) stride += static_cast<std::size_t>(field.bytes);
  records.bytes.resize(stride * cloud.points.size());
  std::uint8_t* at = records.bytes.data();
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    const Point3f& point = cloud.points[i];
    for (const double value :
         {cloud.origin.x() + point.x, cloud.origin.y() + point.y, cloud.origin.z() + point.z}) {
      if (wide) {
        put(at, value);
      } else {
        put(at, static_cast<float>(value));
      }
    }
    if (with_intensity) put(at, cloud.intensity[i]);
    if (with_label) put(at, cloud.label[i]);
  }
  return records;
}

}  // namespace stope::exports
