#pragma once

#include <array>
#include <cstdint>
#include <unordered_map>

#include "plugins/map_source/cell_rule.hpp"

namespace stope::map_source {

using Rgb = std::array<std::uint8_t, 3>;

/// What a pixel of a conical map says.
struct ConePixel {
  std::int16_t hue = -1;  ///< number of the hue; -1: none, the cell has no region
  std::uint8_t cell = 0;  ///< as in an OccupancyGrid
  bool known = true;      ///< false: no such colour is in maps of this kind
};

/// Reads the colours of maps that Stope wrote, each of which stands for one hue and one value.
class StopeCone {
 public:
  /// `floor`: chroma of free cells; `step`: degrees between hues, a divisor of 360.
  StopeCone(int floor, int step);
  ConePixel read(const Rgb& colour) const;

 private:
  std::unordered_map<std::uint32_t, ConePixel> colours_;
};

/// Reads colours by the paper's formulas (Wang et al., eq. 10): saturation is occupancy, hue the
/// region; white has neither and is free.
class PaperCone {
 public:
  PaperCone(int start, int step, double coefficient, const CellRule& rule)
      : start_(start), step_(step), coefficient_(coefficient), rule_(rule) {}
  ConePixel read(const Rgb& colour) const;

 private:
  int start_, step_;
  double coefficient_;
  CellRule rule_;
};

}  // namespace stope::map_source
