#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "stope/payloads/point_cloud.hpp"

namespace stope::exports {

/// A field of a point in a cloud's file.
struct CloudField {
  std::string name;
  char kind;  ///< F floating point, U unsigned
  int bytes;
};

/// A cloud as rows of packed little-endian fields: x y z in the map frame, then intensity and
/// label where the cloud has them. Coordinates are single precision where that is exact to a
/// millimetre, double far from zero (UTM).
struct CloudRecords {
  std::vector<CloudField> fields;
  std::vector<std::uint8_t> bytes;
};

CloudRecords records_of(const PointCloud& cloud);

}  // namespace stope::exports
