#pragma once

#include <array>
#include <cstdint>

namespace stope::exports {

using Rgb = std::array<std::uint8_t, 3>;

/// The colours of the conical map: hue says which region, saturation how occupied (Wang et al.,
/// eqs. 6-8), with two additions that make eight bits enough for every value of an occupancy cell.
/// The least saturation is `floor`/255 instead of 0, which would be white whatever the hue; and
/// where two values share a saturation, the second is one step darker (254 instead of 255). Unknown
/// cells of a region are darker still (205), cells without region grey.
class ConeColours {
 public:
  /// `floor`: chroma of free cells, 3 … 128; `hues`: how many there are around the circle, 6, 12 or
  /// 18.
  ConeColours(int floor, int hues);

  /// A region's cell; `cell` as in an OccupancyGrid.
  Rgb region(int hue, std::uint8_t cell) const;
  /// A cell of no region: free is white, occupied black, unknown 205, as on a map_server map.
  static Rgb grey(std::uint8_t cell);

 private:
  int floor_, hues_;
};

}  // namespace stope::exports
