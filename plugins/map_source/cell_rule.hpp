#pragma once

#include <cstdint>
#include <string>

namespace stope::map_source {

enum class MapMode : int { kTrinary, kScale, kRaw };

/// How a map_server picture tells occupancy, as nav2's map_io reads it. `shade` is a pixel's
/// brightness from 0 (black) to 1 (white); how occupied it is, is 1 - shade, or shade if negated.
///   trinary: above occupied_thresh occupied, below free_thresh free, else unknown
///   scale:   the same, but between the thresholds linear from free to occupied; transparent pixels
///            are unknown
///   raw:     8-bit brightness 0 to 100 is the probability in percent, all else unknown; neither
///            `negate` nor the thresholds are asked
struct CellRule {
  MapMode mode = MapMode::kTrinary;
  bool negate = false;
  double occupied_thresh = 0.65, free_thresh = 0.196;

  /// The value of an OccupancyGrid's cell.
  std::uint8_t cell(double shade, bool transparent) const;
};

}  // namespace stope::map_source
